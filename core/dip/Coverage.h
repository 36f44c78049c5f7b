// How much of the body an immersion paints.
#pragma once

#include "dip/FilmContact.h"

namespace dipwright {

struct Coverage {
    std::vector<std::uint8_t> covered; // a body triangle each: 1 where at least half is painted
    double paintedArea = 0;            // mm²
    double share = 0;                  // of the body's surface, 0 … 1
    double trappedAirArea = 0;         // mm² that film cannot reach because air is caught there
};

// By samples of every body triangle, a few for each film cell's area. All cores, deterministic.
Coverage coverage(const DippedFilm& film, const FilmContact& contact, const PosedBody& body,
                  const SurfaceQuery& query);

} // namespace dipwright
