// Lays a surface flat around a place on it, so that distances from the place and directions at the
// place are kept. This is the inverse of the exponential map. On a developable surface, such as a
// cylinder or the faces on both sides of an edge, all lengths are kept, and straight lines stay
// straight. On a doubly curved surface, lengths across these directions become too short or too
// long. This error grows with the distance from the place and with the curvature.
#pragma once

#include "geometry/RefinedMesh.h"

#include <memory>
#include <optional>

namespace dipwright {

// A right-handed frame at a place on a surface, of unit vectors.
struct SurfaceFrame {
    Eigen::Vector3d right, up, outward;
};

// Returns the frame in which a picture is upright for a viewer who looks along −`outward`, with the
// model's +Y up. If the viewer looks straight down, the picture's up is −Z; if straight up, it is
// +Z.
SurfaceFrame uprightFrame(const Eigen::Vector3d& outward);

// A small piece of a surface that is laid flat.
struct FlatPiece {
    SurfacePoint place;                             // its middle, on the mesh
    Eigen::Vector2d flat = Eigen::Vector2d::Zero(); // its middle in the plane, mm
};

// Uses discrete geodesic polar coordinates (Melvær & Reimers 2012, "Geodesic polar coordinates on
// polygonal meshes"). Computes in double precision on the mesh refined around the place. Immutable,
// any thread may read; the same answer in every run.
class UnfoldedSurface {
public:
    // Unfolds everything within `radius` (> 0) mm of `middle` along the surface. Unfolding
    // continues across seams whose sides differ only by rounding errors. uprightFrame() of the
    // middle's triangle gives the plane's right and up.
    UnfoldedSurface(const TriangleMesh& mesh, const SurfacePoint& middle, double radius);

    // Returns where a place of the mesh lies in the plane, mm to the right and up from the middle;
    // nothing beyond the radius. If several paths lead around an obstacle to a place, the shortest
    // counts.
    std::optional<Eigen::Vector2d> at(const SurfacePoint& place) const;
    // Returns the pieces of the surface within the radius, at most about 1/40 of the radius wide.
    std::vector<FlatPiece> pieces() const;

private:
    using Corners = std::array<Eigen::Vector2d, 3>;

    RefinedMesh fine_;
    double radius_;
    std::vector<Corners> corners_; // places of each fine triangle's corners; NaN if not reached
};

} // namespace dipwright
