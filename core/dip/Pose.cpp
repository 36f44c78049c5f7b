#include "dip/Pose.h"

#include "geometry/FieldGrid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

// If the |cos| of the angle about Y is smaller than this, the X and Z axes coincide.
constexpr double sameAxis = 1e-6;

} // namespace

Eigen::Matrix3d rotationMatrix(const std::array<Degrees, 3>& angles) {
    return (Eigen::AngleAxisd(radians(angles[2]), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(radians(angles[1]), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(radians(angles[0]), Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

Eigen::Vector3d anglesNear(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& aim) {
    // Returns the same rotation, with each angle within ±180° of the aim.
    const auto nearAim = [&](const Eigen::Vector3d& angles) -> Eigen::Vector3d {
        return aim + (angles - aim).unaryExpr([](double a) { return std::remainder(a, 2 * pi); });
    };
    const Eigen::Vector3d zyx = rotation.eulerAngles(2, 1, 0);
    Eigen::Vector3d one(zyx[2], zyx[1], zyx[0]);
    if (std::abs(std::cos(one.y())) < sameAxis) { // gimbal lock: X and Z rotate about one axis
        const double more = aim.x() - one.x();
        one += Eigen::Vector3d(more, 0, std::sin(one.y()) > 0 ? more : -more);
    }
    const Eigen::Vector3d other(one.x() + pi, pi - one.y(), one.z() + pi);
    const bool otherIsNearer =
        (nearAim(other) - aim).squaredNorm() < (nearAim(one) - aim).squaredNorm();
    return nearAim(otherIsNearer ? other : one);
}

std::array<Degrees, 3> rotationAngles(const Eigen::Matrix3d& rotation,
                                      const std::array<Degrees, 3>& near) {
    const Eigen::Vector3d nearest =
        anglesNear(rotation, {radians(near[0]), radians(near[1]), radians(near[2])});
    const auto rounded = [](double angle) {
        const double turn = std::abs(angle) > 2 * pi ? std::remainder(angle, 2 * pi) : angle;
        return Degrees(std::round(turn * 1800 / pi) / 10 + 0.0); // + 0.0 turns −0 into 0
    };
    return {rounded(nearest.x()), rounded(nearest.y()), rounded(nearest.z())};
}

Eigen::Isometry3d poseTransform(const TriangleMesh& model, const Immersion& immersion) {
    const BoundingBox box = boundingBox(model);
    const Eigen::Vector3d centre = (box.min().cast<double>() + box.max().cast<double>()) / 2;
    const Eigen::Matrix3d rotation = rotationMatrix(immersion.rotation);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& point : model.positions) {
        lowest = std::min(lowest, rotation.row(1).dot(point.cast<double>() - centre));
    }
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    transform.linear() = rotation;
    transform.translation() = -(rotation * centre) - Eigen::Vector3d(0, lowest, 0);
    return transform;
}

Eigen::Isometry3d bodyTransform(const TriangleMesh& model, const Immersion& immersion) {
    return poseTransform(model, immersion) * Eigen::Translation3d(bodyOrigin(model));
}

bool PosedBody::isDry(const SurfacePoint& point) const {
    return air.isDry(position(mesh, point), triangleNormal(mesh, point.triangle), query);
}

bool PosedBody::isBuried(const SurfacePoint& point) const {
    return buried.covers(point, mesh, query);
}

PosedBody posedBody(const TriangleMesh& model, const Immersion& immersion,
                    const ProcessSettings& process, int cells) {
    const Eigen::Isometry3d modelToPose = poseTransform(model, immersion);
    TriangleMesh posed = transformed(model, modelToPose);
    const double height = boundingBox(posed).max().y();
    SurfaceQuery query(posed);
    solver::BodyPath path = bodyPath(posed, immersion, process);
    AirPockets air =
        isTilting(path) ? AirPockets(posed, query, path, cells) : AirPockets(posed, query, cells);
    return {std::move(posed), modelToPose,      bodyTransform(model, immersion),
            height,           std::move(query), std::move(air),
            std::move(path)};
}

PosedBody posedBody(const TriangleMesh& model, const Immersion& immersion, int cells) {
    Immersion straight = immersion;
    straight.path = {};
    return posedBody(model, straight, ProcessSettings(), cells);
}

double dipDepth(const ProcessSettings& process, const PosedBody& body) {
    return dipDepth(process, body.height);
}

double dipDepth(const ProcessSettings& process, double height) {
    return process.depth ? process.depth->value() : height + process.margin.value();
}

double dipTravel(const ProcessSettings& process, const PosedBody& body) {
    return body.path.isStraightDown() ? startHeight + dipDepth(process, body)
                                      : body.path.poses.back().travelled;
}

Eigen::Vector3d poseToWorld(const Immersion& immersion, double descent) {
    return {immersion.offset[0].value(), startHeight - descent, immersion.offset[1].value()};
}

Eigen::Isometry3d poseToWorld(const solver::BodyPath& path, const Immersion& immersion,
                              double travelled) {
    if (path.isStraightDown()) {
        return Eigen::Isometry3d(Eigen::Translation3d(poseToWorld(immersion, travelled)));
    }
    return Eigen::Translation3d(immersion.offset[0].value(), 0, immersion.offset[1].value()) *
           placeOnPath(path, travelled);
}

} // namespace dipwright
