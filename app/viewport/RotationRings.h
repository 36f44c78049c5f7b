// Draws three rings around the body, one for each world axis. Dragging a ring with the mouse turns
// the body.
#pragma once

#include "ViewProjection.h"

#include <QColor>
#include <array>
#include <optional>
#include <vector>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

// Returns the colour of an axis for rings and arrows, as in most CAD programs. The colours also
// differ in lightness.
QColor axisColour(int axis);

// Centre and radius of the rings in the world, mm. Finds the ring under the cursor.
struct RotationRings {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    double radius = 50;
    bool visible = false;

    // Returns the axis of the ring within a few pixels of `position`, or nothing.
    std::optional<int> axisAt(QPointF position, const ViewProjection& shown) const;
    // Returns the angle, in degrees, of the point on the ring of `axis` that is drawn nearest to
    // `position`.
    double angleAt(int axis, QPointF position, const ViewProjection& shown) const;

    // Returns the point of the ring of `axis` at this angle.
    Eigen::Vector3f ringPoint(int axis, double degrees) const;
};

// Draws the rings.
class RingActors {
public:
    explicit RingActors(vtkRenderer* renderer);

    void set(const RotationRings& rings);
    void addPlaces(std::vector<Eigen::Vector3d>& places) const; // points on the visible rings
    void highlight(int axis);                                   // −1: no ring
    void setPixelRatio(double ratio);

private:
    RotationRings shown_;
    int lit_ = -1;
    double pixelRatio_ = 1;
    std::array<vtkSmartPointer<vtkActor>, 3> rings_;
};

} // namespace dipwright
