// The frame round a decal in the 3D view, by which it is moved, turned and sized.
#pragma once

#include "geometry/UnfoldedSurface.h"
#include "settings/Artwork.h"
#include "workbench/view/DipScene.h"

#include <optional>

namespace dipwright {

enum class FrameHandle { Move, Turn, Size };

class LayerFrame {
public:
    // `scene` shows the body that the layer lies on, and is asked for its surface.
    LayerFrame(const ArtworkLayer& layer, const DipScene& scene);

    // On the body: the outline, a stalk upwards to turn it by, and squares to take hold of.
    std::vector<ViewLine> lines(const QColor& colour) const;
    // What a press there takes hold of; nothing: none of it. `reach`: mm round a handle.
    std::optional<FrameHandle> handleAt(const ViewRay& ray, double reach) const;
    // The layer as a drag leaves it that began at one place and has come to another.
    ArtworkLayer dragged(FrameHandle handle, const ViewRay& from, const ViewRay& to) const;
    const Eigen::Vector3d& place() const { return place_; }

private:
    // Where a ray meets the plane that touches the body in the middle, turned with the layer, mm.
    std::optional<Eigen::Vector2d> flat(const ViewRay& ray) const;
    Eigen::Vector3f onBody(const Eigen::Vector2d& place) const;

    ArtworkLayer layer_;
    const DipScene& scene_;
    Eigen::Vector3d place_;
    SurfaceFrame frame_;
    Eigen::Vector2d half_; // the size's
};

} // namespace dipwright
