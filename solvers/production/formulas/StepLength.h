// Computes the length of the production film's step and the share of the stress that remains after
// it.
#pragma once

#include "common/Functions.h"

#include <dipwright/FilmSolver.h>

#include <cstddef>

namespace dipwright::numerics {

// Horizontal component of the surface's unit normal: 0 flat, 1 vertical. On faces flatter than
// this, steps do not become shorter any more.
inline constexpr double leastSteepness = 0.15;

// Returns the descent in which the contact line travels `travel` mm along a surface of this
// steepness.
DIPWRIGHT_HOST_DEVICE inline double contactIncrement(double travel, double steepness) {
    return travel * (steepness > leastSteepness ? steepness : leastSteepness);
}

// On a path, the body's vertical motion is measured over this length of travel, mm.
inline constexpr double sinkingTestedOver = 0.1;

// On a path, the body goes down or up by `sinking` mm per mm that it travels. The contact line then
// advances by this vertical motion divided by the steepness. Returns the steepness at which it
// would advance equally far in a straight dip; at most 1, a vertical face.
DIPWRIGHT_HOST_DEVICE inline double steepnessOnPath(double steepness, double sinking) {
    const double least = steepness > leastSteepness ? steepness : leastSteepness;
    return least < sinking ? least / sinking : 1;
}

// Some points have no film on the body near them. Returns the descent after which the first of
// these points may make contact, but at least 10 % of `travel`. So a step does not run past the
// first contact of any part of the body.
DIPWRIGHT_HOST_DEVICE inline double approachIncrement(double travel, double nearestClearance) {
    const double least = 0.1 * travel;
    return nearestClearance > least ? nearestClearance : least;
}

// Returns whether this point, or a point up to two cells away, is on the body.
template <typename IsFree>
DIPWRIGHT_HOST_DEVICE inline bool isNextToContact(int columns, int rows, int point,
                                                  const IsFree& isFree) {
    constexpr int reach = 2;
    const int column = point % columns, row = point / columns;
    for (int j = row > reach ? row - reach : 0; j < rows && j <= row + reach; ++j) {
        for (int i = column > reach ? column - reach : 0; i < columns && i <= column + reach; ++i) {
            if (!isFree(std::size_t(j) * std::size_t(columns) + std::size_t(i))) {
                return true;
            }
        }
    }
    return false;
}

// Returns the share of its stress that the film keeps over a step of `seconds`.
DIPWRIGHT_HOST_DEVICE inline double keptStress(double seconds, double relaxationTime) {
    return relaxationTime > 0 ? decay(-seconds / relaxationTime) : 0.0;
}

} // namespace dipwright::numerics
