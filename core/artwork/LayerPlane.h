// Where a layer's plane lies on a body. Private to this folder.
#pragma once

#include "geometry/CornerNormals.h"
#include "geometry/SurfaceQuery.h"
#include "geometry/UnfoldedSurface.h"
#include "settings/Artwork.h"

#include <array>
#include <memory>
#include <optional>

namespace dipwright {

// Where a place of the body lies in a layer's plane, mm to the right and up from its middle, and
// for what share of the picture that counts.
struct PlanePlace {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    float share = 0; // 0: not at all
};
using PlanePlaces = std::array<PlanePlace, 3>;

// Reading is const, any thread.
class LayerPlane {
public:
    // `size`: of what is shown, LayerPicture::size(). Keeps a reference to the mesh.
    LayerPlane(const ArtworkLayer& layer, const TriangleMesh& mesh, const SurfaceQuery& query,
               const Eigen::Vector2d& size);

    // The shares add up to one, or to nothing where the layer does not reach. More than one place
    // counts only where a box goes over from one side to the next on a rounded body. `outward`: the
    // unit normal of the triangle there.
    PlanePlaces at(const SurfacePoint& place, const Eigen::Vector3d& outward) const;
    // Whether repeats go on past the layer's size.
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
    Eigen::Matrix2d turn_;    // from the surface's plane to the picture's
    double turned_ = 0;       // radians, about a cylinder's axis
    double reach_ = 0;        // mm from the place, of a decal
    double lengthOfTurn_ = 0; // mm once round a cylinder, as the picture counts them
    std::unique_ptr<const UnfoldedSurface> unfolded_; // of a decal
    CornerNormals normals_;                           // of a box
};

} // namespace dipwright
