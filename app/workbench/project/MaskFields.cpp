#include "workbench/project/MaskFields.h"

#include <QComboBox>

namespace dipwright {

MaskFields::MaskFields(LengthUnit unit, QWidget* parent)
    : MarkFields(QStringLiteral("maskBrush"), unit, parent) {
    kind().addItem(tr("Masks with a brush"), int(MarkExtent::Stroke));
    kind().addItem(tr("Masks a whole face"), int(MarkExtent::Face));
    kind().addItem(tr("Masks a whole material or CAD face"), int(MarkExtent::Material));
    kind().setToolTip(tr("What a click or drag on the part does. Masked surface must stay free of "
                         "film: it is covered with tape, the sheet stays blank there, and the "
                         "cradle may touch it."));
    const auto showRadius = [this] {
        setRadiusEnabled(kind().currentData().toInt() == int(MarkExtent::Stroke));
    };
    connect(&kind(), &QComboBox::currentIndexChanged, this, showRadius);
    showRadius();
}

MarkBrush MaskFields::chosen() const {
    const int extent = kind().currentData().toInt();
    if (extent == noKind) {
        return {};
    }
    MaskMark mark;
    mark.extent = MarkExtent(extent);
    mark.radius = radius();
    return mark;
}

} // namespace dipwright
