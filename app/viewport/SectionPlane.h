// A plane across an axis of the world that cuts body and film open in the view.
#pragma once

#include "ViewProjection.h"
#include "geometry/TriangleMesh.h"

#include <array>

namespace dipwright {

struct SectionPlane {
    int axis = 2;       // X, Y or Z
    double place = 0;   // mm along it
    bool after = false; // what lies after the plane is drawn, else what lies before it
    BoundingBox extent; // that its frame is drawn round (world)

    // Of what is drawn: into it.
    Eigen::Vector3f inward() const;
    // Of the frame, in a row.
    std::array<Eigen::Vector3f, 4> corners() const;
    // What of a ray lies where something is drawn.
    ViewRay shownPart(ViewRay ray) const;
    // The frame's point that is shown within some pixels of `position`, or nothing.
    std::optional<Eigen::Vector3f> frameAt(QPointF position, const ViewProjection& shown) const;
};

} // namespace dipwright
