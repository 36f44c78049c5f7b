// Sums up the air trapped under hollows of the body, which film cannot reach.
#pragma once

#include "dip/Pose.h"

#include <optional>

namespace dipwright {

struct TrappedAir {
    double area = 0; // surface of the body in trapped air, mm²
    // How far the body has come down, or travelled on its path, when the water first cuts off air,
    // mm; none without trapped air.
    std::optional<double> travelled;
};

// Adds up the body's air pockets (AirPockets.h). Uses all cores; deterministic.
TrappedAir trappedAir(const PosedBody& body);

} // namespace dipwright
