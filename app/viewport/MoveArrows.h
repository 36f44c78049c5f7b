// Draws the arrows along the world's axes with which the mouse moves the body.
#pragma once

#include "ViewProjection.h"

#include <array>
#include <optional>
#include <vector>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

// The places of the arrows (world). Finds the arrow under the cursor.
struct MoveArrows {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    double begin = 60, end = 80;      // mm from the centre
    std::array<bool, 3> visible = {}; // X, Y, Z

    // Returns the axis of the visible arrow within a few pixels of `position`, or nothing. Ignores
    // an arrow that points at the camera, because it cannot be dragged.
    std::optional<int> axisAt(QPointF position, const ViewProjection& shown) const;
};

// Draws the arrows.
class ArrowActors {
public:
    explicit ArrowActors(vtkRenderer* renderer);

    void set(const MoveArrows& arrows);
    void addPlaces(std::vector<Eigen::Vector3d>& places) const; // tips of the visible arrows
    void highlight(int axis);                                   // −1: no arrow

private:
    MoveArrows shown_;
    std::array<vtkSmartPointer<vtkActor>, 3> arrows_;
};

} // namespace dipwright
