// Sums up the air trapped under hollows of the body, which film cannot reach.
#pragma once

#include "dip/Pose.h"

#include <optional>

namespace dipwright {

struct TrappedAir {
    double area = 0; // surface of the body in trapped air, mm²
    // Lowest level of a pocket above the body's lowest point, mm; none without pockets or on a
    // path.
    std::optional<double> height;
};

// Adds up the body's air pockets (AirPockets.h). Uses all cores; deterministic.
TrappedAir trappedAir(const PosedBody& body);

} // namespace dipwright
