#include "workbench/project/PropertyField.h"

#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright {

namespace {

QHBoxLayout* makeRow(QWidget* owner) {
    auto* row = new QHBoxLayout(owner);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    return row;
}

// Reports a number once it has been typed. Its width fits a usual number.
class PropertyNumberBox : public NumberBox {
public:
    explicit PropertyNumberBox(QWidget* parent) : NumberBox(parent) {
        setKeyboardTracking(false);
        setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        // Setting the text again marks an accepted value as no longer being typed.
        connect(this, &QDoubleSpinBox::editingFinished, this,
                [this] { lineEdit()->setText(lineEdit()->text()); });
    }
    QSize sizeHint() const override {
        const QString usual = prefix() + QStringLiteral("-000.0") + suffix();
        return {fontMetrics().horizontalAdvance(usual) + 30, NumberBox::sizeHint().height()};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }
};

class NumberField : public PropertyField {
public:
    NumberField(const PropertySpec& spec, const FieldRule& rule, LengthUnit length, QWidget* parent)
        : PropertyField(spec, parent), factor_(shownPerStored(spec.unit, length)),
          whole_(rule.kind == FieldKind::WholeNumber), nullable_(rule.nullable) {
        auto* row = makeRow(this);
        if (nullable_) {
            addAbsentTick(*row);
        }
        const int decimals = whole_ ? 0 : unitDecimals(spec.unit, length);
        const QString range = PropertyField::tr("%1 to %2%3")
                                  .arg(locale().toString(rule.minimum * factor_, 'g', 6),
                                       locale().toString(rule.maximum * factor_, 'g', 6),
                                       unitSuffix(spec.unit, length));
        for (int part = 0; part < rule.parts; ++part) {
            auto* box = new PropertyNumberBox(this);
            box->setDecimals(decimals);
            box->setRange(rule.minimum * factor_, rule.maximum * factor_);
            box->setSuffix(unitSuffix(spec.unit, length));
            const QString partName = spec.parts.value(part);
            adopt(box, partName.isEmpty() ? spec.label : spec.label + QLatin1Char(' ') + partName,
                  range);
            if (!partName.isEmpty()) {
                box->setPrefix(partName + QStringLiteral("  "));
            }
            connect(box, &QDoubleSpinBox::valueChanged, this, [this, part] { changed(part); });
            connect(box, &NumberBox::refused, this, &PropertyField::refused);
            connect(box, &QDoubleSpinBox::editingFinished, this, &PropertyField::left);
            if (rule.parts > 2) { // three boxes with room for their longest numbers are too wide
                constexpr int narrow = 92; // pixels
                box->setMinimumWidth(std::min(narrow, box->minimumSizeHint().width()));
            }
            row->addWidget(box, 1);
            boxes_.push_back(box);
        }
        stored_.resize(boxes_.size());
        if (spec.linked) {
            addLink(*row);
        }
    }

    void show(const QJsonValue& value) override {
        shown_ = value;
        if (absent_) {
            const QSignalBlocker quiet(absent_);
            absent_->setChecked(value.isNull());
        }
        for (std::size_t part = 0; part < boxes_.size(); ++part) {
            const QJsonValue own = boxes_.size() == 1 ? value : value.toArray().at(int(part));
            const QSignalBlocker quiet(boxes_[part]);
            boxes_[part]->setEnabled(!value.isNull());
            stored_[part] = own.toDouble(spec().whenPresent);
            boxes_[part]->setValue(stored_[part] * factor_);
        }
        if (link_ && !isOneNumber()) {
            link_->setChecked(false);
        }
    }

private:
    bool isOneNumber() const {
        return std::all_of(stored_.begin(), stored_.end(),
                           [this](double value) { return value == stored_.front(); });
    }
    void addLink(QHBoxLayout& row) {
        link_ = new QToolButton(this);
        link_->setIcon(icon(QStringLiteral("link")));
        link_->setCheckable(true);
        link_->setChecked(true);
        link_->setAutoRaise(true);
        link_->setAccessibleName(spec().label + QLatin1Char(' ') + PropertyField::tr("linked"));
        link_->setToolTip(PropertyField::tr("Linked: typing one number sets the others as well"));
        connect(link_, &QToolButton::clicked, this, [this](bool linked) {
            if (linked && !isOneNumber()) {
                changed(0);
                emit left();
            }
        });
        row.addWidget(link_);
    }
    void addAbsentTick(QHBoxLayout& row) {
        absent_ = new QCheckBox(spec().absent, this);
        adopt(absent_, spec().label + QLatin1Char(' ') + spec().absent, {});
        connect(absent_, &QCheckBox::toggled, this, [this](bool absent) {
            emit edited(absent ? QJsonValue() : QJsonValue(spec().whenPresent));
            emit left();
        });
        row.addWidget(absent_);
    }
    void changed(int part) {
        stored_[std::size_t(part)] = boxes_[std::size_t(part)]->value() / factor_;
        if (boxes_.size() == 1) {
            emit edited(asJson(stored_[0]));
            return;
        }
        if (link_ && link_->isChecked()) {
            std::fill(stored_.begin(), stored_.end(), stored_[std::size_t(part)]);
        }
        QJsonArray parts;
        for (const double value : stored_) {
            parts.append(asJson(value));
        }
        emit edited(parts);
    }
    QJsonValue asJson(double value) const { return whole_ ? std::round(value) : value; }

    double factor_;
    bool whole_, nullable_;
    QCheckBox* absent_ = nullptr;
    QToolButton* link_ = nullptr; // null: the components are independent
    std::vector<QDoubleSpinBox*> boxes_;
    std::vector<double> stored_; // the shown numbers may have fewer digits
    QJsonValue shown_;
};

class ChoiceField : public PropertyField {
public:
    ChoiceField(const PropertySpec& spec, const FieldRule& rule, QWidget* parent)
        : PropertyField(spec, parent), box_(new QComboBox(this)) {
        makeRow(this)->addWidget(box_);
        box_->setFocusPolicy(Qt::StrongFocus);
        box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        // The box is as wide as its words, up to the panel's width; for longer words the row wraps.
        qsizetype letters = 6;
        for (const QString& word : rule.choices) {
            const QString text = spec.words.value(word, word);
            letters = std::max(letters, text.size());
            box_->addItem(text, word);
        }
        box_->setMinimumContentsLength(int(std::min<qsizetype>(letters, 20)));
        adopt(box_, spec.label, {});
        connect(box_, &QComboBox::activated, this, [this](int index) {
            emit edited(box_->itemData(index).toString());
            emit left();
        });
    }
    void show(const QJsonValue& value) override {
        box_->setCurrentIndex(box_->findData(value.toString()));
    }

private:
    QComboBox* box_;
};

class FlagField : public PropertyField {
public:
    FlagField(const PropertySpec& spec, QWidget* parent)
        : PropertyField(spec, parent), box_(new QCheckBox(this)) {
        makeRow(this)->addWidget(box_);
        adopt(box_, spec.label, {});
        connect(box_, &QCheckBox::toggled, this, [this](bool ticked) {
            emit edited(ticked);
            emit left();
        });
    }
    void show(const QJsonValue& value) override {
        const QSignalBlocker quiet(box_);
        box_->setChecked(value.toBool());
    }

private:
    QCheckBox* box_;
};

class TextField : public PropertyField {
public:
    TextField(const PropertySpec& spec, const FieldRule& rule, QWidget* parent)
        : PropertyField(spec, parent), line_(new QLineEdit(this)) {
        auto* row = makeRow(this);
        row->addWidget(line_);
        line_->setMaxLength(int(rule.maximum));
        adopt(line_, spec.label, {});
        connect(line_, &QLineEdit::textEdited, this,
                [this](const QString& text) { emit edited(text); });
        if (spec.isColour) {
            addSwatch(*row);
        }
    }
    void show(const QJsonValue& value) override {
        if (line_->text() != value.toString()) {
            line_->setText(value.toString());
        }
        if (swatch_) {
            swatch_->setIcon(swatchOf(QColor(value.toString())));
        }
    }

private:
    void addSwatch(QHBoxLayout& row) {
        swatch_ = new QToolButton(this);
        swatch_->setObjectName(spec().path + QStringLiteral(".choose"));
        swatch_->setAccessibleName(PropertyField::tr("Choose %1").arg(spec().label));
        swatch_->setToolTip(PropertyField::tr("Choose the colour"));
        connect(swatch_, &QToolButton::clicked, this, [this] {
            const QColor now(line_->text());
            auto* dialog = new QColorDialog(now.isValid() ? now : QColor(Qt::white), this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& colour) {
                emit edited(colour.name());
                emit left();
            });
            dialog->open();
        });
        row.addWidget(swatch_);
    }
    // Returns an empty frame for an invalid colour.
    QIcon swatchOf(const QColor& colour) const {
        QPixmap picture(QSize(14, 14) * devicePixelRatio());
        picture.setDevicePixelRatio(devicePixelRatio());
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setPen(palette().color(QPalette::Mid));
        painter.setBrush(colour.isValid() ? QBrush(colour) : QBrush(Qt::NoBrush));
        painter.drawRect(QRectF(0.5, 0.5, 13, 13));
        return {picture};
    }

    QLineEdit* line_;
    QToolButton* swatch_ = nullptr; // null: the text is not a colour
};

// Undo first reverts the text being typed; without such text it reverts the last change of the
// project.
bool isForTheProject(QObject& editor, const QKeyEvent& key) {
    auto* line = qobject_cast<QLineEdit*>(&editor);
    line = line ? line : editor.findChild<QLineEdit*>();
    return line && ((key.matches(QKeySequence::Undo) && !line->isUndoAvailable()) ||
                    (key.matches(QKeySequence::Redo) && !line->isRedoAvailable()));
}

} // namespace

PropertyField* PropertyField::make(const PropertySpec& spec, const FieldRule& rule,
                                   LengthUnit length, QWidget* parent) {
    switch (rule.kind) {
    case FieldKind::Text:
    case FieldKind::Colour:
        return new TextField(spec, rule, parent);
    case FieldKind::Choice:
        return new ChoiceField(spec, rule, parent);
    case FieldKind::Flag:
        return new FlagField(spec, parent);
    case FieldKind::Number:
    case FieldKind::WholeNumber:
        break;
    }
    return new NumberField(spec, rule, length, parent);
}

void PropertyField::adopt(QWidget* editor, const QString& name, const QString& range) {
    editor->setAccessibleName(name);
    editor->setAccessibleDescription(spec_.help);
    editor->setObjectName(spec_.path);
    editor->setWhatsThis(spec_.help);
    const QString shownRange = range.isEmpty() ? QString() : QLatin1Char('\n') + range;
    editor->setToolTip(spec_.help + shownRange);
    editor->installEventFilter(this);
    if (!focusProxy()) {
        setFocusProxy(editor);
    }
}

bool PropertyField::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        emit left();
    }
    if (event->type() == QEvent::ShortcutOverride &&
        isForTheProject(*watched, static_cast<QKeyEvent&>(*event))) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace dipwright
