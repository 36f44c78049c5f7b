#include "view/BodyTurn.h"

#include <Eigen/Geometry>

namespace dipwright {

Immersion turned(const Immersion& immersion, int axis, double degrees) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(radians(Degrees(degrees)), Eigen::Vector3d::Unit(axis))
            .toRotationMatrix();
    Immersion result = immersion;
    result.rotation = rotationAngles(turn * rotationMatrix(immersion.rotation), immersion.rotation);
    return result;
}

Immersion laidDown(const Immersion& immersion, const Eigen::Vector3d& outward) {
    const Eigen::Matrix3d rotation = rotationMatrix(immersion.rotation);
    const auto turn =
        Eigen::Quaterniond::FromTwoVectors(rotation * outward, -Eigen::Vector3d::UnitY());
    Immersion result = immersion;
    result.rotation = rotationAngles(turn.toRotationMatrix() * rotation, immersion.rotation);
    return result;
}

BodyTurn::BodyTurn(const DipSession& session, const DipView& view, QObject* parent)
    : QObject(parent), session_(session) {
    connect(&view, &DipView::rotationDragged, this, &BodyTurn::drag);
    connect(&view, &DipView::rotationFinished, this, &BodyTurn::finish);
}

void BodyTurn::drag(int axis, double degrees) {
    Document& document = *session_.document();
    if (!before_) {
        before_ = document.project().immersions[session_.immersion()];
        emit held(true);
    }
    document.edit(tr("Turn Body"), QStringLiteral("turn"), [&](Project& project) {
        project.immersions[session_.immersion()].rotation =
            turned(*before_, axis, degrees).rotation;
    });
}

void BodyTurn::finish() {
    before_.reset();
    session_.document()->endMerge();
    emit held(false);
}

} // namespace dipwright
