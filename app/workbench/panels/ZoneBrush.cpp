#include "panels/ZoneBrush.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace dipwright {
namespace {

constexpr int noZone = -1;
constexpr double leastRadius = 0.5, mostRadius = 200, usualRadius = 5; // mm

} // namespace

ZoneBrush::ZoneBrush(LengthUnit unit, QWidget* parent)
    : QWidget(parent), unit_(unit), zone_(new QComboBox), extent_(new QComboBox),
      radius_(new QDoubleSpinBox), count_(new QLabel),
      removeLast_(new QPushButton(tr("Remove Last"))),
      removeAll_(new QPushButton(tr("Remove All"))) {
    zone_->setObjectName(QStringLiteral("zoneBrush"));
    zone_->setAccessibleName(tr("A click on the body"));
    zone_->addItem(tr("Marks nothing"), noZone);
    for (const auto& [zone, name] : {std::pair(Zone::A, "A"), {Zone::B, "B"}, {Zone::C, "C"}}) {
        zone_->addItem(tr("Marks zone %1").arg(QLatin1String(name)), int(zone));
    }
    zone_->setToolTip(tr("What a click on the body in the view marks. Zone A is to be painted most "
                         "exactly; what is not marked is zone C."));
    extent_->setObjectName(QStringLiteral("zoneBrushExtent"));
    extent_->setAccessibleName(tr("How far"));
    extent_->addItem(tr("A spot"), int(ZoneExtent::Spot));
    extent_->addItem(tr("The whole face"), int(ZoneExtent::Face));
    extent_->addItem(tr("All of the material"), int(ZoneExtent::Material));
    extent_->setToolTip(tr("How far round the click the mark reaches: a radius along the surface, "
                           "the face up to its edges, or all that has the same material in the "
                           "model."));
    const double shown = shownPerStored(Unit::Length, unit);
    radius_->setObjectName(QStringLiteral("zoneBrushRadius"));
    radius_->setAccessibleName(tr("Radius"));
    radius_->setDecimals(unitDecimals(Unit::Length, unit));
    radius_->setRange(leastRadius * shown, mostRadius * shown);
    radius_->setValue(usualRadius * shown);
    radius_->setSuffix(unitSuffix(Unit::Length, unit));
    radius_->setToolTip(tr("How far round the click the spot reaches, along the surface."));
    count_->setWordWrap(true);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("A click"), zone_);
    form->addRow(tr("How far"), extent_);
    form->addRow(tr("Radius"), radius_);
    form->addRow(count_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(removeLast_);
    buttons->addWidget(removeAll_);
    form->addRow(buttons);

    connect(zone_, &QComboBox::currentIndexChanged, this, &ZoneBrush::changed);
    connect(radius_, &QDoubleSpinBox::valueChanged, this, &ZoneBrush::changed);
    connect(extent_, &QComboBox::currentIndexChanged, this, [this] {
        radius_->setEnabled(extent_->currentData().toInt() == int(ZoneExtent::Spot));
        emit changed();
    });
    connect(removeLast_, &QPushButton::clicked, this, &ZoneBrush::removeLastAsked);
    connect(removeAll_, &QPushButton::clicked, this, &ZoneBrush::removeAllAsked);
}

std::optional<ZoneMark> ZoneBrush::mark() const {
    const int zone = zone_->currentData().toInt();
    if (zone == noZone) {
        return std::nullopt;
    }
    const double radius = radius_->value() / shownPerStored(Unit::Length, unit_);
    return ZoneMark{
        Zone(zone), {}, ZoneExtent(extent_->currentData().toInt()), Millimetres(radius)};
}

void ZoneBrush::setMarkCount(std::size_t count) {
    count_->setText(tr("Marks on the body: %1").arg(count));
    removeLast_->setEnabled(count > 0);
    removeAll_->setEnabled(count > 0);
}

} // namespace dipwright
