// Which film is on the body for good, and how much of the body it paints.
#pragma once

#include "dip/Dip.h"
#include "geometry/SurfaceQuery.h"

namespace dipwright {

// Where each film point lies on the body: an invalid SurfacePoint where it is not on it.
// "contact": found by the film's normal or the closest point; "filled": interpolated from
// neighbours because the point itself missed.
struct FilmContact {
    std::vector<SurfacePoint> surface;   // a film point each
    std::vector<std::uint8_t> filled;    // 1: from its neighbours
    std::vector<std::uint8_t> painted;   // a film triangle each: 1 = this piece of film is on the body
    std::vector<std::uint8_t> torn;      // a film triangle each: 1 = stretched past the tear limit
    std::size_t contactCount = 0;
    std::size_t filledCount = 0;
};

FilmContact locateFilm(const DippedFilm& film, const PosedBody& body, const SurfaceQuery& query,
                       const ProcessSettings& process);

struct Coverage {
    std::vector<std::uint8_t> covered; // a body triangle each: 1 where at least half is painted
    double paintedArea = 0;            // mm²
    double share = 0;                  // of the body's surface, 0 … 1
    double trappedAirArea = 0;         // mm² that film cannot reach because air is caught there
};
Coverage coverage(const DippedFilm& film, const FilmContact& contact, const PosedBody& body,
                  const SurfaceQuery& query);

} // namespace dipwright
