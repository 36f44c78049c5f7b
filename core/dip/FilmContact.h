// Records which part of the film is on the body after the dip, and where each film point lies.
// FilmThatPaints.h computes it.
#pragma once

#include "geometry/TriangleMesh.h"

#include <map>

namespace dipwright {

struct FilmContact {
    std::vector<SurfacePoint> surface; // per film point: its place; invalid if not on the body
    std::vector<std::uint8_t> painted; // per film triangle: 1 if it is on the body
    std::size_t contactCount = 0;      // points that were found on the body
    std::size_t filledCount = 0;       // points that missed the body and were interpolated

    // Per film point: its place on the body or, if it is off the body, its position in the pose
    // frame. For a point just past the limit of contact: the place that it would have if the film
    // continued along the body.
    std::vector<Eigen::Vector3f> places;
    // The film triangles that the limit of contact crosses; none of them is `painted`. In such a
    // triangle, a place with barycentric weights w is on the body if w · limit ≥ 0.
    std::map<std::uint32_t, Eigen::Vector3f> limits;

    // Whether any part of a film triangle is on the body.
    bool reaches(std::uint32_t triangle) const {
        return painted[triangle] != 0 || limits.contains(triangle);
    }
    // Whether the place with these barycentric weights in a film triangle is on the body.
    bool reaches(std::uint32_t triangle, const Eigen::Vector3f& weights) const {
        if (painted[triangle] != 0) {
            return true;
        }
        const auto limit = limits.find(triangle);
        return limit != limits.end() && weights.dot(limit->second) >= 0;
    }
};

// The film over a hollow counts as touching it if the hollow is at most this deep, in
// film cells. The film's grid cannot resolve shallower hollows.
inline constexpr double touchedHollow = 0.3;

} // namespace dipwright
