#include "workbench/project/SeamFields.h"

#include <QCheckBox>
#include <QComboBox>

namespace dipwright {

SeamFields::SeamFields(LengthUnit unit, QWidget* parent)
    : MarkFields(QStringLiteral("joinBrush"), unit, parent),
      face_(new QCheckBox(tr("Whole face"))) {
    kind().addItem({}, int(ShareMarkKind::First));
    kind().addItem({}, int(ShareMarkKind::Second));
    kind().addItem(tr("Keeps the seam away"), int(ShareMarkKind::Avoid));
    kind().addItem(tr("Allows the seam"), int(ShareMarkKind::Allow));
    kind().setToolTip(tr("What a click or drag on the part does. Assign areas to the other dip to "
                         "move the seam. With “Run live” the seam is updated at once."));
    face_->setToolTip(tr("Marks the whole flat face that you click, up to its edges."));
    insertField(radiusRow + 1, {}, *face_);
    const auto enable = [this] {
        const bool marks = kind().currentData().toInt() != noKind;
        face_->setEnabled(marks);
        setRadiusEnabled(marks && !face_->isChecked());
    };
    connect(&kind(), &QComboBox::currentIndexChanged, this, enable);
    connect(face_, &QCheckBox::toggled, this, [this, enable] {
        enable();
        emit changed();
    });
    enable();
}

MarkBrush SeamFields::chosen() const {
    const int marks = kind().currentData().toInt();
    if (marks == noKind) {
        return {};
    }
    return ShareMark{ShareMarkKind(marks), {}, face_->isChecked() ? Millimetres(0) : radius()};
}

void SeamFields::setDips(const QString& first, const QString& second) {
    const auto name = [&](ShareMarkKind mark, const QString& dip) {
        kind().setItemText(kind().findData(int(mark)), tr("Assigns the place to %1").arg(dip));
    };
    name(ShareMarkKind::First, first);
    name(ShareMarkKind::Second, second);
}

} // namespace dipwright
