// Which film is on the body for good, and where each of its points lies there.
#pragma once

#include "dip/Dip.h"
#include "geometry/SurfaceQuery.h"

namespace dipwright {

// Where each film point lies on the body: an invalid SurfacePoint where it is not on it.
struct FilmContact {
    std::vector<SurfacePoint> surface; // a film point each
    std::vector<std::uint8_t>
        filled; // a film point each: 1 = interpolated, the point itself missed
    std::vector<std::uint8_t>
        painted;                    // a film triangle each: 1 = this piece of film is on the body
    std::vector<std::uint8_t> torn; // a film triangle each: 1 = area or length past the tear limit
    std::size_t contactCount = 0;   // points that are on the body themselves
    std::size_t filledCount = 0;    // points that were filled
};

// Hollows up to this deep, in film cells, count as touched by the film that spans them; the film's
// grid cannot tell better.
inline constexpr double touchedHollow = 0.3;

// Finds the surface point of every adhered film point: the nearest one along the film's normal, or
// the closest one where that ray goes astray. A point that has none is filled from its neighbours
// where it has some on both sides, along the rows and along the columns. A film triangle is painted
// when all its corners lie on the body and it neither tears, nor spans a hollow, nor is folded
// across the body, nor lies on a face that turns up by more than `process.overhang`.
// `film` and `body` are in the same pose frame; `query` asks body.model.mesh. All cores.
FilmContact locateFilm(const DippedFilm& film, const PosedBody& body, const SurfaceQuery& query,
                       const ProcessSettings& process);

} // namespace dipwright
