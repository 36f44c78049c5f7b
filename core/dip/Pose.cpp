#include "dip/Pose.h"

#include <algorithm>
#include <limits>

namespace dipwright {

Eigen::Isometry3d poseTransform(const TriangleMesh& body, const Immersion& immersion) {
    const BoundingBox box = boundingBox(body);
    const Eigen::Vector3d centre = (box.min().cast<double>() + box.max().cast<double>()) / 2;
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(radians(immersion.rotation[2]), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(radians(immersion.rotation[1]), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(radians(immersion.rotation[0]), Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& point : body.positions) {
        lowest = std::min(lowest, rotation.row(1).dot(point.cast<double>() - centre));
    }
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    transform.linear() = rotation;
    transform.translation() = -(rotation * centre) - Eigen::Vector3d(0, lowest, 0);
    return transform;
}

PosedBody posedBody(const TexturedMesh& model, const Immersion& immersion) {
    const Eigen::Isometry3d modelToPose = poseTransform(model.mesh, immersion);
    TexturedMesh posed = model;
    posed.mesh = transformed(model.mesh, modelToPose);
    const double height = boundingBox(posed.mesh).max().y();
    SurfaceQuery query(posed.mesh);
    return {std::move(posed), modelToPose, height, std::move(query)};
}

} // namespace dipwright
