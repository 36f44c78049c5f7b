// How floating film grows with time (docs/film-model.md, "Swell, relaxation and edges").
#pragma once

#include "common/HostDevice.h"

#include <cmath>

namespace dipwright::numerics {

// How many times as long as at the start of the dip its rest shape is after so many seconds: it
// begins to grow by `rate` of its length a second, towards `limit` of it (Settings in
// FilmSolver.h).
DIPWRIGHT_HOST_DEVICE inline double grownLength(double seconds, double rate, double limit) {
    return rate > 0 && limit > 0 ? 1 - limit * std::expm1(-rate * seconds / limit) : 1.0;
}

} // namespace dipwright::numerics
