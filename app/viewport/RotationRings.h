// Three rings round the body, one an axis of the world, by which it is turned with the mouse.
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <array>
#include <functional>
#include <optional>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

class RotationRings {
public:
    // World to widget coordinates.
    using Projection = std::function<QPointF(const Eigen::Vector3f&)>;

    explicit RotationRings(vtkRenderer* renderer);

    void setPlace(const Eigen::Vector3f& centre, double radius);
    void setVisible(bool visible);
    bool isVisible() const { return visible_; }
    void highlight(int axis); // −1: none
    void setPixelRatio(double ratio);

    // The ring that passes within some pixels of `position`, or nothing.
    std::optional<int> axisAt(QPointF position, const Projection& project) const;
    // The angle on the ring of `axis`, in degrees, of the ring point that is shown nearest to
    // `position`.
    double angleAt(int axis, QPointF position, const Projection& project) const;

private:
    Eigen::Vector3f ringPoint(int axis, double degrees) const;

    Eigen::Vector3f centre_ = Eigen::Vector3f::Zero();
    double radius_ = 50;
    bool visible_ = false;
    int lit_ = -1;
    double pixelRatio_ = 1;
    std::array<vtkSmartPointer<vtkActor>, 3> rings_;
};

} // namespace dipwright
