// Turns and moves the body of a dip as it is shown in the view.
#pragma once

#include "settings/Immersion.h"

#include <Eigen/Core>
#include <optional>

namespace dipwright {

// How the body is shown.
struct ShownPose {
    // The pose of the path (DipPath::keys) that is changed; none: the dip's rotation and offset.
    std::optional<std::size_t> key;
    // The shown rotation relative to the dip's final one.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

// Returns `immersion` with its body turned by `degrees` about the world's X, Y or Z axis, as seen
// in the view. The angles are rounded to 0.1°. A turn by 0 changes nothing.
Immersion turned(const Immersion& immersion, int axis, double degrees, const ShownPose& shown = {});

// Returns `from` moved by `millimetres`, rounded to 1 nm.
double moved(double from, double millimetres);

// Returns `immersion` with its body, or the shown pose of its path, moved along X (axis 0) or Z
// (axis 2) by `millimetres`, rounded to 1 nm.
Immersion moved(const Immersion& immersion, int axis, double millimetres, const ShownPose& shown);

// Returns `immersion` turned so that the face with the normal `outward` (model coordinates) points
// down at the end of the dip. Uses the smallest rotation. The angles are rounded to 0.1°.
Immersion withFaceDown(const Immersion& immersion, const Eigen::Vector3d& outward);

} // namespace dipwright
