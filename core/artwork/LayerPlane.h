// Maps places on a body to a layer's plane. Private to this folder.
#pragma once

#include "geometry/CornerNormals.h"
#include "geometry/SurfaceQuery.h"
#include "geometry/UnfoldedSurface.h"
#include "settings/Artwork.h"

#include <array>
#include <memory>
#include <optional>

namespace dipwright {

// A place in a layer's plane, mm to the right and up from the plane's middle, and its weight.
struct PlanePlace {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    float share = 0; // weight, 0 … 1; 0 is ignored
};
using PlanePlaces = std::array<PlanePlace, 3>;

// Returns the length of a turn around a cylinder layer's axis, mm, at the mean distance of the
// surface that looks away from it.
double lengthAround(const ArtworkLayer& layer, const TriangleMesh& mesh);

// Immutable; any thread may read.
class LayerPlane {
public:
    // `size` is LayerPicture::size(). Keeps a reference to the mesh.
    LayerPlane(const ArtworkLayer& layer, const TriangleMesh& mesh, const SurfaceQuery& query,
               const Eigen::Vector2d& size);

    // Returns up to three places in the plane that together give the content at a place on the
    // body. The shares add up to 1, or to 0 where the layer does not reach. There are several
    // places only where a box blends from one side to the next. `outward` is the unit normal of the
    // triangle.
    PlanePlaces at(const SurfacePoint& place, const Eigen::Vector3d& outward) const;
    // Returns the share of a decal that is lost because another body of the model covers the
    // surface: the decal ends where it enters that body, as seen from the decal's middle.
    // 0 for other placements. `size` is that of the decal, mm.
    double coveredShare(const Eigen::Vector2d& size) const;
    // Whether repeats continue past the layer's size.
    bool isEndless() const { return placement_ != LayerPlacement::Decal; }

private:
    std::optional<Eigen::Vector2d> single(const SurfacePoint& point,
                                          const Eigen::Vector3d& outward) const;
    PlanePlaces boxed(const SurfacePoint& point) const;
    Eigen::Vector2d projected(const Eigen::Vector3d& place, const SurfaceFrame& frame) const;
    std::optional<Eigen::Vector2d> round(const Eigen::Vector3d& place,
                                         const Eigen::Vector3d& outward) const;

    const TriangleMesh& mesh_;
    LayerPlacement placement_;
    Eigen::Vector3d place_, axis_;
    Eigen::Matrix2d turn_;    // rotation from the surface's plane to the picture's
    double turned_ = 0;       // rotation about a cylinder's axis, radians
    double reach_ = 0;        // a decal's radius, mm
    double lengthOfTurn_ = 0; // circumference of a cylinder in the picture, mm
    std::unique_ptr<const UnfoldedSurface> unfolded_; // used for a decal
    CornerNormals normals_;                           // used for a box
};

} // namespace dipwright
