#include "workbench/document/PoseEdits.h"

#include "dip/Pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dipwright {

Immersion turned(const Immersion& immersion, int axis, double degrees, const ShownPose& shown) {
    if (degrees == 0) {
        return immersion;
    }
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(radians(Degrees(degrees)), Eigen::Vector3d::Unit(axis))
            .toRotationMatrix();
    Immersion result = immersion;
    if (shown.key && *shown.key + 1 < immersion.path.keys.size()) { // the last one has no turn
        std::array<Degrees, 3>& angles = result.path.keys[*shown.key].turn;
        angles = rotationAngles(turn * rotationMatrix(angles), angles);
        return result;
    }
    const Eigen::Matrix3d seen = shown.turn.transpose() * turn * shown.turn;
    result.rotation = rotationAngles(seen * rotationMatrix(immersion.rotation), immersion.rotation);
    return result;
}

double moved(double from, double millimetres) {
    constexpr double steps = 1e6; // per mm: finer than any number that is typed
    return millimetres == 0 ? from : std::round(steps * (from + millimetres)) / steps;
}

Immersion moved(const Immersion& immersion, int axis, double millimetres, const ShownPose& shown) {
    constexpr double farthest = 5000; // as in the project file (core/project/Schema.cpp)
    Immersion result = immersion;
    std::array<Millimetres, 2>& place =
        shown.key ? result.path.keys[*shown.key].beside : result.offset;
    Millimetres& part = place[axis == 0 ? 0 : 1];
    part = Millimetres(std::clamp(moved(part.value(), millimetres), -farthest, farthest));
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

} // namespace dipwright
