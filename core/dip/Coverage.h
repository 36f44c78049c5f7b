// How much of the body dips paint.
#pragma once

#include "base/Progress.h"
#include "dip/FilmMarks.h"
#include "dip/TrappedAir.h"

namespace dipwright {

struct Coverage {
    std::vector<std::uint8_t> covered; // a body triangle each: 1 where at least half is painted
    // A body triangle each: the solver::PointMark bits of at least half of what is painted of it.
    std::vector<std::uint8_t> marks;
    double paintedArea = 0; // mm²
    MarkedArea marked;      // of that
    double share = 0;       // of the body's surface, 0 … 1
    TrappedAir trappedAir;  // film cannot reach where it is
};

// Of one dip. By samples of every body triangle, a few for each film cell's area. All cores,
// deterministic.
Coverage coverage(const LaidFilm& laid);

// The share of the surface that at least one of several films of the same body paints, by samples
// spread evenly over it. Throws Cancelled.
double coverageTogether(const std::vector<std::shared_ptr<const LaidFilm>>& films,
                        const Progress& progress);

} // namespace dipwright
