// Three rings round the body, one an axis of the world, by which it is turned with the mouse.
#pragma once

#include "ViewProjection.h"

#include <QColor>
#include <array>
#include <optional>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

// Of what turns and moves the body, as in every CAD program, told apart by lightness as well.
QColor axisColour(int axis);

// Where the rings are (world), and which of them is under the cursor.
struct RotationRings {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    double radius = 50;
    bool visible = false;

    // The ring that passes within some pixels of `position`, or nothing.
    std::optional<int> axisAt(QPointF position, const ViewProjection& shown) const;
    // The angle on the ring of `axis`, in degrees, of the ring point that is shown nearest to
    // `position`.
    double angleAt(int axis, QPointF position, const ViewProjection& shown) const;

private:
    Eigen::Vector3f ringPoint(int axis, double degrees) const;
};

// How they are drawn.
class RingActors {
public:
    explicit RingActors(vtkRenderer* renderer);

    void set(const RotationRings& rings);
    void highlight(int axis); // −1: none
    void setPixelRatio(double ratio);

private:
    int lit_ = -1;
    double pixelRatio_ = 1;
    std::array<vtkSmartPointer<vtkActor>, 3> rings_;
};

} // namespace dipwright
