// Arrows along the axes of the world beside the rings, by which the body is moved with the mouse.
#pragma once

#include "ViewProjection.h"

#include <array>
#include <optional>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

// Where the arrows are (world), and which of them is under the cursor.
struct MoveArrows {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    double begin = 60, end = 80;      // mm from the centre
    std::array<bool, 3> visible = {}; // X, Y, Z

    // The arrow that is shown within some pixels of `position`, or nothing. One that points at the
    // eye is none: nothing could be dragged along it.
    std::optional<int> axisAt(QPointF position, const ViewProjection& shown) const;
};

// How they are drawn.
class ArrowActors {
public:
    explicit ArrowActors(vtkRenderer* renderer);

    void set(const MoveArrows& arrows);
    void highlight(int axis); // −1: none

private:
    std::array<vtkSmartPointer<vtkActor>, 3> arrows_;
};

} // namespace dipwright
