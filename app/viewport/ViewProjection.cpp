#include "ViewProjection.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace dipwright {

double placeAlong(int axis, const Eigen::Vector3f& held, const ViewRay& ray) {
    const Eigen::Vector3f away = ray.origin - held;
    const float along = ray.direction[axis];
    const float across = 1 - along * along;
    if (across < 1e-4f) {
        return double(held[axis]);
    }
    return double(held[axis] + (away[axis] - along * away.dot(ray.direction)) / across);
}

QPointF ViewProjection::positionOf(const Eigen::Vector3f& place) const {
    const Eigen::Vector4d shown = worldToClip * place.cast<double>().homogeneous();
    return {(shown.x() / shown.w() + 1) / 2 * size.width(),
            (1 - shown.y() / shown.w()) / 2 * size.height()};
}

ViewRay ViewProjection::rayAt(QPointF position) const {
    const Eigen::Matrix4d clipToWorld = worldToClip.inverse();
    const auto world = [&](double depth) -> Eigen::Vector3d {
        return (clipToWorld * Eigen::Vector4d(2 * position.x() / size.width() - 1,
                                              1 - 2 * position.y() / size.height(), depth, 1))
            .hnormalized();
    };
    const Eigen::Vector3d near = world(-1), far = world(1);
    return {near.cast<float>(), (far - near).normalized().cast<float>()};
}

} // namespace dipwright
