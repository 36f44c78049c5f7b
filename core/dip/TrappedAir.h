// Air caught under hollows of the body while the water rises round it: film cannot reach there.
#pragma once

#include "dip/Pose.h"

#include <optional>

namespace dipwright {

struct TrappedAir {
    double area = 0;              // mm² of the body that stay in air when it goes under
    std::optional<double> height; // of the lowest of its levels over the body's lowest point, mm
};

// Of the body's air pockets (AirPockets.h), in the pose frame. All cores, deterministic.
TrappedAir trappedAir(const PosedBody& body);

} // namespace dipwright
