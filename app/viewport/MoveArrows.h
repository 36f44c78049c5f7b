// The arrows along the world's axes beside the rings, which move the body with the mouse.
#pragma once

#include "ViewProjection.h"

#include <array>
#include <optional>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

// The places of the arrows (world), and which one is under the cursor.
struct MoveArrows {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    double begin = 60, end = 80;      // mm from the centre
    std::array<bool, 3> visible = {}; // X, Y, Z

    // The visible arrow within a few pixels of `position`, or nothing. An arrow that points at the
    // eye cannot be dragged and is ignored.
    std::optional<int> axisAt(QPointF position, const ViewProjection& shown) const;
};

// Draws the arrows.
class ArrowActors {
public:
    explicit ArrowActors(vtkRenderer* renderer);

    void set(const MoveArrows& arrows);
    void highlight(int axis); // −1: none

private:
    std::array<vtkSmartPointer<vtkActor>, 3> arrows_;
};

} // namespace dipwright
