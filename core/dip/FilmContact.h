// Records which film is on the body after the dip, and where each of its points lies.
// FilmThatPaints.h computes it.
#pragma once

#include "geometry/TriangleMesh.h"

#include <map>

namespace dipwright {

struct FilmContact {
    std::vector<SurfacePoint> surface; // per film point; invalid if it is not on the body
    std::vector<std::uint8_t> painted; // per film triangle: 1 if it is on the body
    std::size_t contactCount = 0;      // points that were found on the body
    std::size_t filledCount = 0;       // points that missed the body and were interpolated

    // Per film point: its place on the body or, if it is off the body, its position in the pose
    // frame. Just past the limit of contact: its place if the film continued along the body.
    std::vector<Eigen::Vector3f> places;
    // The film triangles that the limit of contact crosses; none of them is `painted`. Film at
    // barycentric weights w of the corners is on the body if w · limit ≥ 0.
    std::map<std::uint32_t, Eigen::Vector3f> limits;

    // Whether any part of a film triangle is on the body; and whether the place with these
    // barycentric weights is.
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

// Depth in film cells up to which a hollow counts as touched by the film over it. The film's grid
// cannot resolve less.
inline constexpr double touchedHollow = 0.3;

} // namespace dipwright
