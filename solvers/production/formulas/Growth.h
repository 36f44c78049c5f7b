// Computes the growth of floating film over time (docs/film-model.md, "Swell, relaxation and
// edges").
#pragma once

#include "common/Functions.h"

namespace dipwright::numerics {

// Returns the rest length of floating film after `seconds`, relative to its length at the start of
// the dip. Growth starts with `rate` of the length per second and approaches `limit` of the length
// (Settings in FilmSolver.h).
DIPWRIGHT_HOST_DEVICE inline double grownLength(double seconds, double rate, double limit) {
    return rate > 0 && limit > 0 ? 1 + limit * (1 - decay(-rate * seconds / limit)) : 1.0;
}

} // namespace dipwright::numerics
