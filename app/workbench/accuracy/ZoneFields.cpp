#include "workbench/accuracy/ZoneFields.h"

#include <QComboBox>
#include <QFormLayout>

namespace dipwright {

ZoneFields::ZoneFields(LengthUnit unit, QWidget* parent)
    : MarkFields(QStringLiteral("zoneBrush"), unit, parent), extent_(new QComboBox) {
    for (const auto& [zone, name] : {std::pair(Zone::A, "A"), {Zone::B, "B"}, {Zone::C, "C"}}) {
        kind().addItem(tr("Marks zone %1").arg(QLatin1String(name)), int(zone));
    }
    kind().setToolTip(tr("What a click or a drag on the body in the view marks. Zone A is to be "
                         "painted most exactly; what is not marked is zone C."));
    extent_->setObjectName(QStringLiteral("zoneBrushExtent"));
    extent_->setAccessibleName(tr("How far"));
    extent_->addItem(tr("A spot"), int(ZoneExtent::Spot));
    extent_->addItem(tr("The whole face"), int(ZoneExtent::Face));
    extent_->addItem(tr("All of the material"), int(ZoneExtent::Material));
    extent_->setToolTip(tr("How far round the click the mark reaches: a radius along the surface, "
                           "the face up to its edges, or all that has the same material in the "
                           "model."));
    form().insertRow(radiusRow, tr("How far"), extent_);
    connect(extent_, &QComboBox::currentIndexChanged, this, [this] {
        setRadiusEnabled(extent_->currentData().toInt() == int(ZoneExtent::Spot));
        emit changed();
    });
}

MarkBrush ZoneFields::brush() const {
    const int zone = kind().currentData().toInt();
    if (zone == noKind) {
        return {};
    }
    return ZoneMark{Zone(zone), {}, ZoneExtent(extent_->currentData().toInt()), radius()};
}

} // namespace dipwright
