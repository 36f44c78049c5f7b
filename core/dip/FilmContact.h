// Which film is on the body for good, and where each of its points lies there.
#pragma once

#include "dip/Dip.h"
#include "geometry/SurfaceQuery.h"

#include <map>

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

    // A film point each: where it lies on the body, or where the film is. Of a point just past the
    // limit of contact: where it would lie if the film went on.
    std::vector<Eigen::Vector3f> places;
    // The film triangles, none of them `painted`, that the limit of contact runs through: film at
    // the corners' weights w is on the body where w · limit ≥ 0.
    std::map<std::uint32_t, Eigen::Vector3f> limits;

    // Whether any of a film triangle is on the body, and whether it is at the corners' weights.
    bool reaches(std::uint32_t triangle) const {
        return painted[triangle] != 0 || limits.contains(triangle);
    }
    bool reaches(std::uint32_t triangle, const Eigen::Vector3f& weights) const {
        const auto limit = limits.find(triangle);
        return limit == limits.end() ? painted[triangle] != 0 : weights.dot(limit->second) >= 0;
    }
};

// Hollows up to this deep, in film cells, count as touched by the film that spans them; the film's
// grid cannot tell better.
inline constexpr double touchedHollow = 0.3;

// Finds the surface point of every adhered film point: the nearest one along the film's normal, or
// the closest one where that ray goes astray. A point that has none is filled from its neighbours
// where it has some on both sides, along the rows and along the columns. A film triangle is painted
// when all its corners lie on the body and it neither tears, nor spans a hollow, nor is folded
// across the body, nor lies on a face that turns up by more than `process.overhang`. The film's
// last points on the body are short of the limit of contact by a cell or so; isotropic film is
// continued up to it, see ContactLimit.h. `film` and `body` are in the same pose frame; `query`
// asks body.model.mesh. All cores.
FilmContact locateFilm(const DippedFilm& film, const PosedBody& body, const SurfaceQuery& query,
                       const ProcessSettings& process);

// Whether the film's edge has ended up on the body: it was too small for it, and where the edge
// lies the film may lie over itself.
bool edgeIsOnBody(const DippedFilm& film, const FilmContact& contact);

} // namespace dipwright
