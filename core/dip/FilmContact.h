// Which film is on the body for good, and where each of its points lies there. FilmThatPaints.h
// finds it.
#pragma once

#include "geometry/TriangleMesh.h"

#include <map>

namespace dipwright {

// Where each film point lies on the body: an invalid SurfacePoint where it is not on it.
struct FilmContact {
    std::vector<SurfacePoint> surface; // a film point each
    std::vector<std::uint8_t>
        painted;                  // a film triangle each: 1 = this piece of film is on the body
    std::size_t contactCount = 0; // points that are on the body themselves
    std::size_t filledCount = 0;  // points that missed and were interpolated

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
        if (painted[triangle] != 0) {
            return true;
        }
        const auto limit = limits.find(triangle);
        return limit != limits.end() && weights.dot(limit->second) >= 0;
    }
};

// Hollows up to this deep, in film cells, count as touched by the film that spans them; the film's
// grid cannot tell better.
inline constexpr double touchedHollow = 0.3;

} // namespace dipwright
