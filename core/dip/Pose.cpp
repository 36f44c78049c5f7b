#include "dip/Pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

Eigen::Matrix3d rotationMatrix(const std::array<Degrees, 3>& angles) {
    return (Eigen::AngleAxisd(radians(angles[2]), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(radians(angles[1]), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(radians(angles[0]), Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

std::array<Degrees, 3> rotationAngles(const Eigen::Matrix3d& rotation) {
    const Eigen::Vector3d zyx = rotation.eulerAngles(2, 1, 0);
    const auto rounded = [](double angle) {
        return Degrees(std::round(angle * 1800 / pi) / 10 + 0.0); // 0 for −0
    };
    return {rounded(zyx[2]), rounded(zyx[1]), rounded(zyx[0])};
}

Eigen::Isometry3d poseTransform(const TriangleMesh& body, const Immersion& immersion) {
    const BoundingBox box = boundingBox(body);
    const Eigen::Vector3d centre = (box.min().cast<double>() + box.max().cast<double>()) / 2;
    const Eigen::Matrix3d rotation = rotationMatrix(immersion.rotation);
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

double dipDepth(const ProcessSettings& process, const PosedBody& body) {
    return process.depth ? process.depth->value() : body.height + process.margin.value();
}

double dipTravel(const ProcessSettings& process, const PosedBody& body) {
    return startHeight + dipDepth(process, body);
}

Eigen::Vector3d poseToWorld(const Immersion& immersion, double descent) {
    return {immersion.offset[0].value(), startHeight - descent, immersion.offset[1].value()};
}

} // namespace dipwright
