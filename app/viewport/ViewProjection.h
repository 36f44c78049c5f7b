// Converts between world places and pixels of the view's picture.
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>
#include <array>

namespace dipwright {

// The ray from the camera through a pixel, in the world frame.
struct ViewRay {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    Eigen::Vector3f direction = -Eigen::Vector3f::UnitY(); // unit length
};

// Takes the line through `held` that is parallel to the world's X, Y or Z. Finds the point of this
// line that is nearest to the ray, and returns its coordinate on this axis. Returns the coordinate
// of `held` if the ray is parallel to the axis.
double placeAlong(int axis, const Eigen::Vector3f& held, const ViewRay& ray);

// The camera's position, in mm, world frame.
struct ViewCamera {
    std::array<double, 3> place{}, focus{}, up{};
    double scale = 1; // half of the visible height, for parallel projection
    bool isParallel = false;
    bool operator==(const ViewCamera&) const = default;
};

struct ViewProjection {
    Eigen::Matrix4d worldToClip = Eigen::Matrix4d::Identity(); // −1 … 1 in the visible part
    QSizeF size{1, 1}; // size of the picture, in widget coordinates

    QPointF positionOf(const Eigen::Vector3f& place) const;
    ViewRay rayAt(QPointF position) const;
};

} // namespace dipwright
