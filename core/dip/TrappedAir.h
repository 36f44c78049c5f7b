// Air caught under hollows of the body while the water rises round it: film cannot reach there.
#pragma once

#include "dip/Pose.h"

#include <optional>

namespace dipwright {

struct TrappedAir {
    double area = 0;              // mm² of the body that stay in air when it goes under
    std::optional<double> height; // of the lowest of it over the body's lowest point, mm
};

// For the body of the pose frame. Air at a height gets away when it can reach the open without ever
// going below that height; found on a grid of `resolution` cells along the body's longest edge, so
// that hollows of less than a cell are not seen. All cores, deterministic.
TrappedAir trappedAir(const PosedBody& body, int resolution = 96);

} // namespace dipwright
