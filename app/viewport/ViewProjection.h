// How a picture of the view shows the world: from places to pixels and back.
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>

namespace dipwright {

// What lies under the cursor: from the camera through the pixel, world frame.
struct ViewRay {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    Eigen::Vector3f direction = -Eigen::Vector3f::UnitY(); // unit length
};

struct ViewProjection {
    Eigen::Matrix4d worldToClip = Eigen::Matrix4d::Identity(); // −1 … 1 in what is seen
    QSizeF size{1, 1};                                         // of the picture, widget coordinates

    QPointF positionOf(const Eigen::Vector3f& place) const;
    ViewRay rayAt(QPointF position) const;
};

} // namespace dipwright
