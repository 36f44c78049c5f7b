#include "workbench/widgets/MarkFields.h"

#include "workbench/widgets/NumberBox.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

namespace dipwright {
namespace {

constexpr double leastRadius = 0.5, mostRadius = 200, usualRadius = 5; // mm
constexpr int sizeSteps = 200;                                         // of the slider
constexpr double keyFactor = 1.2;

// Converts a radius in mm to a step of the slider, and back.
int stepOf(double radius) {
    return int(std::lround(sizeSteps * std::log(radius / leastRadius) /
                           std::log(mostRadius / leastRadius)));
}

double radiusOf(int step) {
    return leastRadius * std::pow(mostRadius / leastRadius, double(step) / sizeSteps);
}

} // namespace

MarkFields::MarkFields(const QString& name, LengthUnit unit, QWidget* parent)
    : QWidget(parent), unit_(unit), form_(new QFormLayout(this)), kind_(new QComboBox),
      radius_(new NumberBox), size_(new QSlider(Qt::Horizontal)),
      eraser_(new QPushButton(tr("Eraser"))), byName_(new QWidget), names_(new QComboBox),
      mark_(new QPushButton(tr("Mark"))), count_(new QLabel),
      removeLast_(new QPushButton(tr("Remove last"))),
      removeAll_(new QPushButton(tr("Remove all"))) {
    kind_->setObjectName(name);
    kind_->setAccessibleName(tr("A click on the part"));
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(8);
    kind_->addItem(tr("Marks nothing"), noKind);
    const double shown = shownPerStored(Unit::Length, unit);
    radius_->setObjectName(name + QStringLiteral("Radius"));
    radius_->setAccessibleName(tr("Radius"));
    radius_->setDecimals(unitDecimals(Unit::Length, unit));
    radius_->setRange(leastRadius * shown, mostRadius * shown);
    radius_->setValue(usualRadius * shown);
    radius_->setSuffix(unitSuffix(Unit::Length, unit));
    radius_->setToolTip(tr("Radius of the brush on the part. The keys [ and ] change it."));
    size_->setObjectName(name + QStringLiteral("Size"));
    size_->setAccessibleName(tr("Radius"));
    size_->setToolTip(radius_->toolTip());
    size_->setRange(0, sizeSteps);
    showRadius();
    eraser_->setObjectName(name + QStringLiteral("Eraser"));
    eraser_->setCheckable(true);
    eraser_->setToolTip(tr("Strokes on the part take the area out of the marks. Hold Shift to "
                           "erase with a single stroke."));
    count_->setWordWrap(true);

    form_->setContentsMargins(0, 0, 0, 0);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->addRow(tr("Click on part"), kind_);
    form_->addRow(tr("Radius"), radius_);
    auto* tools = new QHBoxLayout;
    tools->addWidget(size_, 1);
    tools->addWidget(eraser_);
    form_->addRow(tools);
    addNames();
    form_->addRow(count_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(removeLast_);
    buttons->addWidget(removeAll_);
    form_->addRow(buttons);

    connect(kind_, &QComboBox::currentIndexChanged, this, &MarkFields::changed);
    connect(radius_, &QDoubleSpinBox::valueChanged, this, [this] {
        showRadius();
        emit changed();
    });
    connect(size_, &QSlider::valueChanged, this, [this](int step) {
        radius_->setValue(radiusOf(step) * shownPerStored(Unit::Length, unit_));
    });
    connect(eraser_, &QAbstractButton::toggled, this, &MarkFields::changed);
    for (const auto& [key, factor] : {std::pair("[", 1 / keyFactor), {"]", keyFactor}}) {
        auto* shortcut = new QShortcut(QKeySequence(QLatin1String(key)), this);
        connect(shortcut, &QShortcut::activated, this, [this, factor = factor] { resize(factor); });
    }
    connect(removeLast_, &QPushButton::clicked, this, &MarkFields::removeLastAsked);
    connect(removeAll_, &QPushButton::clicked, this, &MarkFields::removeAllAsked);
}

void MarkFields::addNames() {
    names_->setObjectName(kind_->objectName() + QStringLiteral("Name"));
    names_->setAccessibleName(tr("By name"));
    names_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    names_->setMinimumContentsLength(8);
    names_->setEditable(true); // typing finds a name among many
    names_->setInsertPolicy(QComboBox::NoInsert);
    names_->setToolTip(tr("A face of the CAD model, or a material, by its name. The mark stays on "
                          "it when the triangles are made again."));
    mark_->setObjectName(kind_->objectName() + QStringLiteral("MarkName"));
    mark_->setToolTip(tr("Marks this face or material as chosen above."));
    auto* row = new QHBoxLayout(byName_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(names_, 1);
    row->addWidget(mark_);
    form_->addRow(tr("By name"), byName_);
    form_->setRowVisible(byName_, false);
    const auto enable = [this] {
        mark_->setEnabled(kind_->currentData().toInt() != noKind &&
                          names_->findText(names_->currentText()) >= 0);
    };
    enable();
    connect(kind_, &QComboBox::currentIndexChanged, this, enable);
    connect(names_, &QComboBox::currentTextChanged, this, enable);
    connect(mark_, &QPushButton::clicked, this, [this] { emit nameChosen(names_->currentText()); });
}

void MarkFields::setNames(const QStringList& names) {
    form_->setRowVisible(byName_, !names.isEmpty());
    QStringList shown;
    for (int row = 0; row < names_->count(); ++row) {
        shown.append(names_->itemText(row));
    }
    if (shown != names) {
        names_->clear();
        names_->addItems(names);
    }
}

Millimetres MarkFields::radius() const {
    return Millimetres(radius_->value() / shownPerStored(Unit::Length, unit_));
}

MarkBrush MarkFields::brush() const {
    const bool erases = eraser_->isChecked() && eraser_->isEnabled();
    return erases ? eraserOf(chosen()) : chosen();
}

void MarkFields::setRadiusEnabled(bool enabled) {
    radius_->setEnabled(enabled);
    size_->setEnabled(enabled);
    if (eraser_->isEnabled() != enabled) {
        eraser_->setEnabled(enabled);
        emit changed(); // the brush may erase now, or no longer
    }
}

void MarkFields::insertField(int row, const QString& label, QWidget& field) {
    if (label.isEmpty()) {
        form_->insertRow(row, &field);
    } else {
        form_->insertRow(row, label, &field);
    }
    setTabOrder(form_->itemAt(row - 1, QFormLayout::FieldRole)->widget(), &field);
}

void MarkFields::resize(double factor) {
    if (radius_->isEnabled()) {
        radius_->setValue(radius_->value() * factor);
    }
}

void MarkFields::showRadius() {
    const QSignalBlocker quiet(size_);
    size_->setValue(stepOf(radius().value()));
}

void MarkFields::setMarkCount(std::size_t count) {
    count_->setText(tr("Marks on the part: %1").arg(count));
    removeLast_->setEnabled(count > 0);
    removeAll_->setEnabled(count > 0);
}

} // namespace dipwright
