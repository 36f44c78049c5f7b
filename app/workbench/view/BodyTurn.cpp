#include "view/BodyTurn.h"

#include <cmath>

namespace dipwright {

Immersion turned(const Immersion& immersion, int axis, double degrees) {
    const auto angle = [&](int part) { return radians(immersion.rotation[std::size_t(part)]); };
    using Eigen::AngleAxisd, Eigen::Vector3d;
    const Eigen::Matrix3d before =
        (AngleAxisd(angle(2), Vector3d::UnitZ()) * AngleAxisd(angle(1), Vector3d::UnitY()) *
         AngleAxisd(angle(0), Vector3d::UnitX()))
            .toRotationMatrix();
    const Eigen::Matrix3d after =
        AngleAxisd(radians(Degrees(degrees)), Vector3d::Unit(axis)).toRotationMatrix() * before;
    const Vector3d angles = after.eulerAngles(2, 1, 0) * 180 / pi; // about Z, Y, X
    Immersion result = immersion;
    for (int part = 0; part < 3; ++part) {
        result.rotation[std::size_t(part)] = Degrees(std::round(angles[2 - part] * 10) / 10);
    }
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
        emit begun();
    }
    document.edit(tr("Turn Body"), QStringLiteral("turn"), [&](Project& project) {
        project.immersions[session_.immersion()].rotation =
            turned(*before_, axis, degrees).rotation;
    });
}

void BodyTurn::finish() {
    before_.reset();
    session_.document()->endMerge();
    emit ended();
}

} // namespace dipwright
