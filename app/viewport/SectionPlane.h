// A plane across a world axis that cuts body and film open in the view.
#pragma once

#include "ViewProjection.h"
#include "geometry/TriangleMesh.h"

#include <array>

namespace dipwright {

struct SectionPlane {
    int axis = 2;       // X, Y or Z
    double place = 0;   // mm along the axis
    bool after = false; // the side after the plane is drawn, else the side before it
    BoundingBox extent; // the frame surrounds this box (world)

    // The normal that points into the drawn side.
    Eigen::Vector3f inward() const;
    // The corners of the frame, in order.
    std::array<Eigen::Vector3f, 4> corners() const;
    // The part of a ray on the drawn side.
    ViewRay shownPart(ViewRay ray) const;
    // The frame's point within a few pixels of `position`, or nothing.
    std::optional<Eigen::Vector3f> frameAt(QPointF position, const ViewProjection& shown) const;
};

} // namespace dipwright
