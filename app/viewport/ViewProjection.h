// How a picture of the view shows the world: from places to pixels and back.
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>
#include <array>

namespace dipwright {

// What lies under the cursor: from the camera through the pixel, world frame.
struct ViewRay {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    Eigen::Vector3f direction = -Eigen::Vector3f::UnitY(); // unit length
};

// Where along the world's X, Y or Z, through `held`, the ray passes nearest; `held` itself where
// the ray goes along the axis.
double placeAlong(int axis, const Eigen::Vector3f& held, const ViewRay& ray);

// Where the camera stands, mm, world frame.
struct ViewCamera {
    std::array<double, 3> place{}, focus{}, up{};
    double scale = 1; // half of the height that is seen; of parallel projections
    bool isParallel = false;
    bool operator==(const ViewCamera&) const = default;
};

struct ViewProjection {
    Eigen::Matrix4d worldToClip = Eigen::Matrix4d::Identity(); // −1 … 1 in what is seen
    QSizeF size{1, 1};                                         // of the picture, widget coordinates

    QPointF positionOf(const Eigen::Vector3f& place) const;
    ViewRay rayAt(QPointF position) const;
};

} // namespace dipwright
