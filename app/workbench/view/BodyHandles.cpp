#include "workbench/view/BodyHandles.h"

#include <Eigen/Geometry>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// The limits of the project file (core/project/Schema.cpp).
constexpr double mostOffset = 5000, leastDepth = 0.1, mostDepth = 5000;

Millimetres placed(double millimetres, double least, double most) {
    return Millimetres(std::clamp(std::round(10 * millimetres) / 10, least, most));
}

QString axisName(int axis) {
    return QString(QLatin1Char("XYZ"[axis]));
}

} // namespace

Immersion turned(const Immersion& immersion, int axis, double degrees) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(radians(Degrees(degrees)), Eigen::Vector3d::Unit(axis))
            .toRotationMatrix();
    Immersion result = immersion;
    result.rotation = rotationAngles(turn * rotationMatrix(immersion.rotation), immersion.rotation);
    return result;
}

Immersion withFaceDown(const Immersion& immersion, const Eigen::Vector3d& outward) {
    const Eigen::Matrix3d rotation = rotationMatrix(immersion.rotation);
    const auto turn =
        Eigen::Quaterniond::FromTwoVectors(rotation * outward, -Eigen::Vector3d::UnitY());
    Immersion result = immersion;
    result.rotation = rotationAngles(turn.toRotationMatrix() * rotation, immersion.rotation);
    return result;
}

BodyHandles::BodyHandles(const DipSession& session, const DipView& view, QObject* parent)
    : QObject(parent), session_(session) {
    connect(&view, &DipView::rotationDragged, this, &BodyHandles::turn);
    connect(&view, &DipView::rotationFinished, this, &BodyHandles::finish);
    connect(&view, &DipView::moveDragged, this, &BodyHandles::move);
    connect(&view, &DipView::moveFinished, this, &BodyHandles::finish);
}

void BodyHandles::hold() {
    if (!before_) {
        const Project& project = session_.document()->project();
        before_ = project.immersions[session_.immersion()];
        depthBefore_ = project.process.depth;
        emit held(true);
    }
}

void BodyHandles::turn(int axis, double degrees) {
    hold();
    session_.document()->edit(tr("Turn part"), QStringLiteral("turn"), [&](Project& project) {
        project.immersions[session_.immersion()].rotation =
            turned(*before_, axis, degrees).rotation;
    });
    emit told(tr("Turned by %1° about %2 (hold Shift for steps of %3°)")
                  .arg(QLocale().toString(degrees, 'f', 1), axisName(axis),
                       QLocale().toString(ringStep)));
}

void BodyHandles::move(int axis, double millimetres) {
    hold();
    Document& document = *session_.document();
    const QString steps = shownLength(arrowStep, unit_);
    if (axis == 1) {
        if (depthBefore_) {
            const Millimetres depth =
                placed(depthBefore_->value() - millimetres, leastDepth, mostDepth);
            document.edit(tr("Change depth"), QStringLiteral("depth"),
                          [&](Project& project) { project.process.depth = depth; });
            emit told(tr("Depth %1 (hold Shift for steps of %2)")
                          .arg(shownLength(depth.value(), unit_), steps));
        }
        return;
    }
    const std::size_t part = axis == 0 ? 0 : 1;
    const Millimetres offset =
        placed(before_->offset[part].value() + millimetres, -mostOffset, mostOffset);
    document.edit(tr("Move part"), QStringLiteral("move"), [&](Project& project) {
        project.immersions[session_.immersion()].offset[part] = offset;
    });
    emit told(tr("Moved to %1 along %2 (hold Shift for steps of %3)")
                  .arg(shownLength(offset.value(), unit_), axisName(axis), steps));
}

void BodyHandles::finish() {
    before_.reset();
    session_.document()->endMerge();
    emit held(false);
}

} // namespace dipwright
