#include "workbench/widgets/NumberBox.h"

#include "base/TypedNumber.h"
#include "workbench/widgets/PlainTexts.h"
#include "workbench/widgets/Theme.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTimer>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace dipwright {

// A value, or the reason why there is no value.
struct NumberBox::Reading {
    std::optional<double> value;
    QString refusal;
};

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    connect(lineEdit(), &QLineEdit::textChanged, this, &NumberBox::showReading);
}

void NumberBox::focusInEvent(QFocusEvent* event) {
    QCoreApplication::instance()->installEventFilter(this);
    QDoubleSpinBox::focusInEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
    QCoreApplication::instance()->removeEventFilter(this);
    QDoubleSpinBox::focusOutEvent(event);
}

bool NumberBox::eventFilter(QObject* watched, QEvent* event) {
    bool leaves = false;
    if (event->type() == QEvent::MouseButtonPress) {
        const auto* widget = qobject_cast<const QWidget*>(watched);
        leaves = widget && widget != this && !isAncestorOf(widget);
    } else if (event->type() == QEvent::ShortcutOverride) {
        leaves = watched == this && isShortcut(*static_cast<const QKeyEvent*>(event));
    } else if (event->type() == QEvent::Close) {
        leaves = watched == window();
    }
    if (leaves && lineEdit()->isModified()) {
        interpretText();
    }
    return false;
}

// Whether the key is for the window and not for the text.
bool NumberBox::isShortcut(const QKeyEvent& key) {
    const bool isModifier = key.key() == Qt::Key_Control || key.key() == Qt::Key_Shift ||
                            key.key() == Qt::Key_Alt || key.key() == Qt::Key_Meta ||
                            key.key() == Qt::Key_AltGr;
    const bool isForWindow =
        (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0 ||
        (key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35);
    if (isModifier || !isForWindow) {
        return false;
    }
    QKeyEvent asked(QEvent::ShortcutOverride, key.key(), key.modifiers(), key.text());
    asked.ignore();
    lineEdit()->event(&asked); // accepts what it needs for editing
    return !asked.isAccepted();
}

int NumberBox::wholeValue() const {
    return int(std::lround(value()));
}

// Returns the text without the prefix and suffix that the field shows.
QString NumberBox::ownText(const QString& text) const {
    const auto first = text.startsWith(prefix()) ? prefix().size() : 0;
    const auto last = text.endsWith(suffix()) ? text.size() - suffix().size() : text.size();
    return text.mid(first, std::max<qsizetype>(0, last - first)).trimmed();
}

NumberBox::Reading NumberBox::read(const QString& text) const {
    if (!specialValueText().isEmpty() && text == specialValueText()) {
        return {minimum(), {}};
    }
    const QString own = ownText(text);
    const QString unit = suffix().trimmed();
    const TypedNumber typed = typedNumber(own, unit, locale());
    if (typed.fault != TypedNumber::Fault::None) {
        return {{}, refusalOf(own, typed)};
    }
    return readingOf(own, typed.values);
}

// Says why the text `own` was not read.
QString NumberBox::refusalOf(const QString& own, const TypedNumber& typed) const {
    const QString unit = suffix().trimmed();
    if (own.isEmpty()) {
        return tr("The field is empty; type a number");
    }
    if (typed.fault == TypedNumber::Fault::NotANumber) {
        return tr("“%1” is not a number").arg(own);
    }
    if (typed.fault == TypedNumber::Fault::TooLarge) {
        return outsideRange(own);
    }
    if (unit.isEmpty()) {
        return tr("“%1” has a unit, but this field has none; type only the number").arg(own);
    }
    return typed.fault == TypedNumber::Fault::UnknownUnit
               ? tr("“%1” is not a unit that this field knows; type a number in %2")
                     .arg(typed.unit, unit)
               : tr("“%1” has a unit that does not fit this field; type a number in %2")
                     .arg(own, unit);
}

QString NumberBox::shown(double value) const {
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(value, 'g', 12);
}

QString NumberBox::outsideRange(const QString& own) const {
    return tr("“%1” is outside the range %2 to %3%4")
        .arg(own, shown(minimum()), shown(maximum()), suffix());
}

// Chooses among `values`, the possible meanings of the typed text `own`, the one that the field
// accepts.
NumberBox::Reading NumberBox::readingOf(const QString& own,
                                        const std::vector<double>& values) const {
    constexpr double rounding = 1e-9; // of units and calculations
    std::vector<double> within;
    for (const double value : values) {
        const double bound = qBound(minimum(), value, maximum());
        if (std::abs(value - bound) <= rounding * std::abs(bound)) {
            within.push_back(bound);
        }
    }
    if (within.empty()) {
        return {{}, outsideRange(own)};
    }
    if (within.size() > 1) {
        return {{},
                tr("“%1” can mean %2 or %3; type one of them")
                    .arg(own, shown(within[0]), shown(within[1]))};
    }
    if (decimals() > 0) {
        return {within[0], {}};
    }
    const double whole = std::round(within[0]);
    if (std::abs(within[0] - whole) > rounding * std::abs(whole)) {
        return {{}, tr("“%1” is not a whole number").arg(own)};
    }
    return {whole, {}};
}

// Any text stays until it is read as a whole.
QValidator::State NumberBox::validate(QString& text, int&) const {
    constexpr int longest = 60;
    if (text.size() > longest + prefix().size() + suffix().size()) {
        return QValidator::Invalid;
    }
    return read(text).value ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
    return read(text).value.value_or(value());
}

// Called when invalid text is entered, or the field loses the focus with it; the value then stays.
void NumberBox::fixup(QString& text) const {
    const QString refusal = read(text).refusal;
    if (refusal.isEmpty()) {
        return;
    }
    emit refused(refusal);
    // Later, the old value is shown again (Qt does not tell the line edit's listeners), and the
    // focus has moved, which would close a tooltip.
    auto* self = const_cast<NumberBox*>(this);
    QTimer::singleShot(0, self, [self, refusal] {
        self->showReading();
        if (self->isVisible()) {
            constexpr int shownFor = 10'000; // ms
            QToolTip::showText(self->mapToGlobal(self->rect().bottomLeft()), inLines(refusal), self,
                               {}, shownFor);
        }
    });
}

void NumberBox::showReading() {
    const QString text = lineEdit()->text();
    const std::optional<double> result = read(text).value;
    QPalette colours = palette();
    if (!result) {
        colours.setColor(QPalette::Text, isDark() ? QColor(255, 130, 120) : QColor(190, 20, 20));
    }
    lineEdit()->setPalette(colours);
    const QString shown = result ? textFromValue(*result) + suffix() : QString();
    const bool isPlain =
        QRegularExpression(QStringLiteral("^[−+\\d.,-]+$")).match(ownText(text)).hasMatch();
    if (lineEdit()->isModified() && hasFocus()) {
        QToolTip::showText(mapToGlobal(rect().bottomLeft()),
                           shown.isEmpty() || isPlain ? QString() : QStringLiteral("= ") + shown,
                           this);
    }
}

QString NumberBox::textFromValue(double value) const {
    QString text = QDoubleSpinBox::textFromValue(value);
    const QString point = locale().decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith(locale().zeroDigit())) {
            text.chop(1);
        }
        if (text.endsWith(point)) {
            text.chop(point.size());
        }
    }
    return text;
}

} // namespace dipwright
