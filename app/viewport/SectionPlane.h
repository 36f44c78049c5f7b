// A plane across a world axis that cuts body and film open in the view.
#pragma once

#include "ViewProjection.h"
#include "geometry/TriangleMesh.h"

#include <array>

namespace dipwright {

struct SectionPlane {
    int axis = 2;       // 0, 1, 2: X, Y, Z
    double place = 0;   // mm along the axis
    bool after = false; // true: the side after the plane is drawn; false: the side before it
    BoundingBox extent; // the frame surrounds this box (world)

    // Returns the normal that points into the drawn side.
    Eigen::Vector3f inward() const;
    // Returns the corners of the frame, in order around it.
    std::array<Eigen::Vector3f, 4> corners() const;
    // Returns the part of a ray that lies on the drawn side.
    ViewRay shownPart(ViewRay ray) const;
    // Returns the frame's point within a few pixels of `position`, or nothing.
    std::optional<Eigen::Vector3f> frameAt(QPointF position, const ViewProjection& shown) const;
};

} // namespace dipwright
