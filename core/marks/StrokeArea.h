// The surface that a brush stroke marks: all places within its radius of a path, if they face the
// path. It does not depend on the triangles, so large triangles are marked as exactly as small
// ones.
#pragma once

#include "geometry/TriangleMesh.h"
#include "settings/SurfaceMark.h"

#include <limits>
#include <vector>

namespace dipwright {

// A surface faces a point of the stroke if the cosine of the angle between both normals is at least
// this: about 104°, so that a stroke goes round an edge, but not through a wall.
inline constexpr float leastFacing = -0.25f;

// Returns a place of a mark.
inline Eigen::Vector3f modelPlace(const std::array<Millimetres, 3>& place) {
    return {float(place[0].value()), float(place[1].value()), float(place[2].value())};
}

// Any number of threads may read. Model coordinates, mm.
class StrokeArea {
public:
    StrokeArea(const BrushPath& path, Millimetres radius);

    void add(const BrushPoint& point); // to the end of the path

    float radius() const { return radius_; }
    // Returns the length of the marked area's border on a plane, mm, or more.
    float borderLength() const { return borderLength_; }
    // Contains the whole marked surface.
    const BoundingBox& box() const { return box_; }
    // Returns the distance from a place to the part of the path that a surface with the unit normal
    // `outward` faces. Infinity if there is none within `limit`. On a plane it changes by at most
    // the way between two places.
    float distance(const Eigen::Vector3f& place, const Eigen::Vector3f& outward,
                   float limit = std::numeric_limits<float>::infinity()) const;
    bool contains(const Eigen::Vector3f& place, const Eigen::Vector3f& outward) const {
        return box_.contains(place) && distance(place, outward, radius_) <= radius_;
    }

private:
    struct Point {
        Eigen::Vector3f place, outward;
    };
    std::vector<Point> points_;
    std::vector<BoundingBox> runs_; // boxes of `runLength` segments each
    BoundingBox box_;
    float radius_, borderLength_ = 0;
};

// Returns the triangles whose middle a stroke marks, in ascending order. Uses all cores.
std::vector<std::uint32_t> trianglesOf(const TriangleMesh& mesh, const StrokeArea& stroke);

} // namespace dipwright
