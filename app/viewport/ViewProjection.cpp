#include "ViewProjection.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace dipwright {

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
