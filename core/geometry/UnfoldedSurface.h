// A surface laid flat round a place on it, so that distances from the place and directions at it
// are kept: the inverse of the exponential map. On a surface that can be unrolled, as a cylinder or
// the faces on both sides of an edge, all lengths are kept and straight lines stay straight; on one
// that is curved in two ways what is far from the place is as much too short or too long across as
// its curvature makes it.
#pragma once

#include "geometry/RefinedMesh.h"

#include <memory>
#include <optional>

namespace dipwright {

// A right-handed frame of a place on a surface, unit vectors.
struct SurfaceFrame {
    Eigen::Vector3d right, up, outward;
};

// The frame in which a picture is upright for whoever looks along −`outward` with the model's +Y
// up; where that looks straight down (or up) upright is away from him, −Z (or +Z).
SurfaceFrame uprightFrame(const Eigen::Vector3d& outward);

// By discrete geodesic polar coordinates (Melvær & Reimers 2012, "Geodesic polar coordinates on
// polygonal meshes") on the mesh cut finer round the place, in double precision. Immutable, any
// thread may read; the same answer in every run.
class UnfoldedSurface {
public:
    // Of all within `radius` (> 0) mm of `middle` along the surface, over seams whose two sides
    // only a rounding parts. Right and up of the plane are
    // those of uprightFrame() of the middle's triangle.
    UnfoldedSurface(const TriangleMesh& mesh, const SurfacePoint& middle, double radius);

    // Where a place of the mesh lies in the plane, mm to the right and up from the middle; nothing
    // past the radius. Where several ways lead round an obstacle to a place the shortest counts.
    std::optional<Eigen::Vector2d> at(const SurfacePoint& place) const;

private:
    using Corners = std::array<Eigen::Vector2d, 3>;

    RefinedMesh fine_;
    double radius_;
    std::vector<Corners> corners_; // of each fine triangle; NaN where they were not reached
};

} // namespace dipwright
