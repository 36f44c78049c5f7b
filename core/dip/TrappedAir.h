// Air caught under hollows of the body while the water rises round it: film cannot reach there.
#pragma once

#include "dip/Pose.h"

namespace dipwright {

// The body's area in mm² that stays in air when the body of the pose frame goes under. Air at a
// height gets away when it can reach the open without ever going below that height; found on a grid
// of `resolution` cells along the body's longest edge, so that hollows of less than a cell are not
// seen. All cores, deterministic.
double trappedAirArea(const PosedBody& body, int resolution = 96);

} // namespace dipwright
