#include "workbench/widgets/MarkFields.h"

#include "workbench/widgets/NumberBox.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace dipwright {
namespace {

constexpr double leastRadius = 0.5, mostRadius = 200, usualRadius = 5; // mm

} // namespace

MarkFields::MarkFields(const QString& name, LengthUnit unit, QWidget* parent)
    : QWidget(parent), unit_(unit), form_(new QFormLayout(this)), kind_(new QComboBox),
      radius_(new NumberBox), count_(new QLabel), removeLast_(new QPushButton(tr("Remove last"))),
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
    radius_->setToolTip(tr("Radius of the mark around the click, along the surface."));
    count_->setWordWrap(true);

    form_->setContentsMargins(0, 0, 0, 0);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->addRow(tr("Click on part"), kind_);
    form_->addRow(tr("Radius"), radius_);
    form_->addRow(count_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(removeLast_);
    buttons->addWidget(removeAll_);
    form_->addRow(buttons);

    connect(kind_, &QComboBox::currentIndexChanged, this, &MarkFields::changed);
    connect(radius_, &QDoubleSpinBox::valueChanged, this, &MarkFields::changed);
    connect(removeLast_, &QPushButton::clicked, this, &MarkFields::removeLastAsked);
    connect(removeAll_, &QPushButton::clicked, this, &MarkFields::removeAllAsked);
}

Millimetres MarkFields::radius() const {
    return Millimetres(radius_->value() / shownPerStored(Unit::Length, unit_));
}

void MarkFields::setRadiusEnabled(bool enabled) {
    radius_->setEnabled(enabled);
}

void MarkFields::setMarkCount(std::size_t count) {
    count_->setText(tr("Marks on the part: %1").arg(count));
    removeLast_->setEnabled(count > 0);
    removeAll_->setEnabled(count > 0);
}

} // namespace dipwright
