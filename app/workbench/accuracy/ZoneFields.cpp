#include "workbench/accuracy/ZoneFields.h"

#include <QComboBox>

namespace dipwright {

ZoneFields::ZoneFields(LengthUnit unit, QWidget* parent)
    : MarkFields(QStringLiteral("zoneBrush"), unit, parent), extent_(new QComboBox) {
    for (const auto& [zone, name] : {std::pair(Zone::A, "A"), {Zone::B, "B"}, {Zone::C, "C"}}) {
        kind().addItem(tr("Marks zone %1").arg(QLatin1String(name)), int(zone));
    }
    kind().setToolTip(tr("The zone that a click or drag on the part sets. Zone A must be painted "
                         "most precisely. The surface without a mark is zone C."));
    extent_->setObjectName(QStringLiteral("zoneBrushExtent"));
    extent_->setAccessibleName(tr("Extent"));
    extent_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    extent_->setMinimumContentsLength(8);
    extent_->addItem(tr("Brush"), int(MarkExtent::Stroke));
    extent_->addItem(tr("Whole face"), int(MarkExtent::Face));
    extent_->addItem(tr("Whole material or CAD face"), int(MarkExtent::Material));
    extent_->setToolTip(
        tr("What a click marks: the surface under the brush, the face up to its edges, or "
           "everything with the same material in the model."));
    insertField(radiusRow, tr("Extent"), *extent_);
    const auto enable = [this] {
        const bool marks = kind().currentData().toInt() != noKind;
        extent_->setEnabled(marks);
        setRadiusEnabled(marks && extent_->currentData().toInt() == int(MarkExtent::Stroke));
    };
    connect(&kind(), &QComboBox::currentIndexChanged, this, enable);
    connect(extent_, &QComboBox::currentIndexChanged, this, [this, enable] {
        enable();
        emit changed();
    });
    enable();
}

MarkBrush ZoneFields::chosen() const {
    const int zone = kind().currentData().toInt();
    if (zone == noKind) {
        return {};
    }
    ZoneMark mark;
    mark.zone = Zone(zone);
    mark.extent = MarkExtent(extent_->currentData().toInt());
    mark.radius = radius();
    return mark;
}

} // namespace dipwright
