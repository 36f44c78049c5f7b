// The frame around a decal in the 3D view. It moves, turns and resizes the decal.
#pragma once

#include "geometry/UnfoldedSurface.h"
#include "settings/Artwork.h"
#include "workbench/view/DipScene.h"

#include <optional>

namespace dipwright {

enum class FrameHandle { Move, Turn, Size };

class LayerFrame {
public:
    // `scene` must show the body that the layer lies on, and must outlive the frame.
    LayerFrame(const ArtworkLayer& layer, const DipScene& scene);

    // Returns lines on the body: the outline, a stalk to the turn handle, and the square handles.
    std::vector<ViewLine> lines(const QColor& colour) const;
    // Returns the handle that a press takes hold of, if any. `reach`: largest distance from the ray
    // to a handle, mm.
    std::optional<FrameHandle> handleAt(const ViewRay& ray, double reach) const;
    // Returns the layer after a drag of `handle` from the ray `from` to the ray `to`.
    ArtworkLayer dragged(FrameHandle handle, const ViewRay& from, const ViewRay& to) const;
    const Eigen::Vector3d& place() const { return place_; }

private:
    // Returns the place where a ray meets the tangent plane at the layer's centre, in the layer's
    // axes, mm.
    std::optional<Eigen::Vector2d> flat(const ViewRay& ray) const;
    Eigen::Vector3f onBody(const Eigen::Vector2d& place) const;

    ArtworkLayer layer_;
    const DipScene& scene_;
    Eigen::Vector3d place_;
    SurfaceFrame frame_;
    Eigen::Vector2d half_; // half width and half height, mm
};

} // namespace dipwright
