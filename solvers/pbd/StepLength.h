// How far the production film's step goes, and what the film's stress has decayed to by then.
#pragma once

#include "pbd/HostDevice.h"

#include <dipwright/FilmSolver.h>

#include <cmath>

namespace dipwright::pbd {

// On a face flatter than this, the step is no shorter.
inline constexpr double leastSteepness = 0.15;

// Descent in which the contact line travels `travel` mm along a surface of this steepness.
DIPWRIGHT_HOST_DEVICE inline double contactIncrement(double travel, double steepness) {
    return travel * (steepness > leastSteepness ? steepness : leastSteepness);
}

// Where nothing has touched: as far as the nearest point is away.
DIPWRIGHT_HOST_DEVICE inline double approachIncrement(double travel, double nearestClearance) {
    const double least = 0.1 * travel;
    return nearestClearance > least ? nearestClearance : least;
}

// The share of its stress that the film keeps over a step of `increment` mm at `speed` mm/s.
DIPWRIGHT_HOST_DEVICE inline double keptStress(double increment, double speed,
                                               double relaxationTime) {
    return relaxationTime > 0 ? std::exp(-(increment / speed) / relaxationTime) : 0.0;
}

} // namespace dipwright::pbd
