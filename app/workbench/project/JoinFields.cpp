#include "workbench/project/JoinFields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>

namespace dipwright {

JoinFields::JoinFields(LengthUnit unit, QWidget* parent)
    : MarkFields(QStringLiteral("joinBrush"), unit, parent),
      face_(new QCheckBox(tr("The whole face"))) {
    kind().addItem({}, int(ShareMarkKind::First));
    kind().addItem({}, int(ShareMarkKind::Second));
    kind().addItem(tr("Keeps the join away"), int(ShareMarkKind::Avoid));
    kind().addItem(tr("Lets the join run there"), int(ShareMarkKind::Allow));
    kind().setToolTip(
        tr("What a click or a drag on the body in the view marks there. Give places "
           "to the other dip to move the join. With Run Live the join follows at once."));
    face_->setToolTip(tr("Marks the flat face that is clicked, up to its edges."));
    form().insertRow(radiusRow + 1, face_);
    connect(face_, &QCheckBox::toggled, this, [this](bool whole) {
        setRadiusEnabled(!whole);
        emit changed();
    });
}

MarkBrush JoinFields::brush() const {
    const int marks = kind().currentData().toInt();
    if (marks == noKind) {
        return {};
    }
    return ShareMark{ShareMarkKind(marks), {}, face_->isChecked() ? Millimetres(0) : radius()};
}

void JoinFields::setDips(const QString& first, const QString& second) {
    const auto name = [&](ShareMarkKind mark, const QString& dip) {
        kind().setItemText(kind().findData(int(mark)), tr("Gives the place to %1").arg(dip));
    };
    name(ShareMarkKind::First, first);
    name(ShareMarkKind::Second, second);
}

} // namespace dipwright
