#include "accuracy/tolerance/ChangedPath.h"

#include "dip/BodyPath.h"

#include <algorithm>

namespace dipwright {
namespace {

Eigen::Map<Eigen::Vector3d> vectorOf(std::array<double, 3>& values) {
    return Eigen::Map<Eigen::Vector3d>(values.data());
}
Eigen::Map<const Eigen::Vector3d> vectorOf(const std::array<double, 3>& values) {
    return Eigen::Map<const Eigen::Vector3d>(values.data());
}

// Returns the mean speed at which the pivot moves on the whole path, mm/s, but at least 0.1 mm/s.
double speedOf(const solver::BodyPath& path) {
    double way = 0;
    for (std::size_t pose = 1; pose < path.poses.size(); ++pose) {
        way += (vectorOf(path.poses[pose].pivot) - vectorOf(path.poses[pose - 1].pivot)).norm();
    }
    return std::max(way / path.poses.back().seconds, 0.1);
}

void setRotation(solver::PathPose& pose, const Eigen::Quaterniond& rotation) {
    pose.rotation = {rotation.w(), rotation.x(), rotation.y(), rotation.z()};
}

} // namespace

Degrees changedAngle(const DipPath& path, double degrees) {
    return travellableAngle(path.kind, path.angle + Degrees(degrees));
}

ChangedPath::ChangedPath(solver::BodyPath path, const TriangleMesh& body)
    : path_(std::move(path)), body_(body) {}

void ChangedPath::speedUp(double speed, const Eigen::Vector3d& water) {
    for (solver::PathPose& pose : path_.poses) {
        const double seconds = pose.seconds / speed;
        vectorOf(pose.pivot) += (pose.seconds - seconds) * water;
        pose.seconds = seconds;
    }
}

void ChangedPath::holdDifferently(const Eigen::Isometry3d& held) {
    vectorOf(path_.pivot) = held.inverse() * vectorOf(path_.pivot);
    const Eigen::Quaterniond turn(held.linear());
    for (solver::PathPose& pose : path_.poses) {
        setRotation(pose, (rotationOf(pose) * turn).normalized());
    }
}

void ChangedPath::move(double x, double z) {
    for (solver::PathPose& pose : path_.poses) {
        vectorOf(pose.pivot) += Eigen::Vector3d(x, 0, z);
    }
}

void ChangedPath::turn(const Eigen::Quaterniond& by) {
    for (solver::PathPose& pose : path_.poses) {
        vectorOf(pose.pivot) = by * vectorOf(pose.pivot);
        setRotation(pose, (by * rotationOf(pose)).normalized());
    }
}

double ChangedPath::lowest(const solver::PathPose& pose) const {
    return lowestPoint(body_, Eigen::Translation3d(vectorOf(pose.pivot)) * rotationOf(pose) *
                                  Eigen::Translation3d(-vectorOf(path_.pivot)));
}

void ChangedPath::raiseWater(double level) {
    level = std::max(level, lowest(path_.poses.back()));
    for (solver::PathPose& pose : path_.poses) {
        pose.pivot[1] -= level;
    }
    if (level > 0) {
        extendBackwards(level);
    }
}

// Extends the first part of the path backwards until the body was higher by `height`; upright if
// the body turns or travels there more than it sinks.
void ChangedPath::extendBackwards(double height) {
    constexpr double flattest = 6; // travel for each mm that the body sinks; 10° to the water: 5.8
    constexpr double mostTurn = 0.1; // radians, of the extension
    const solver::PathPose &first = path_.poses[0], &second = path_.poses[1];
    const double sinks = lowest(first) - lowest(second);
    const double travels = (vectorOf(second.pivot) - vectorOf(first.pivot)).norm();
    Eigen::AngleAxisd back(rotationOf(first) * rotationOf(second).conjugate());
    solver::PathPose before = first;
    if (sinks > 0 && travels <= flattest * sinks && back.angle() * height <= mostTurn * sinks) {
        const double share = height / sinks;
        before.seconds -= share * (second.seconds - first.seconds);
        vectorOf(before.pivot) -= share * (vectorOf(second.pivot) - vectorOf(first.pivot));
        back.angle() *= share;
        setRotation(before, (back * rotationOf(first)).normalized());
    } else {
        before.pivot[1] += height;
        before.seconds -= height / speedOf(path_);
    }
    path_.poses.insert(path_.poses.begin(), before);
    for (solver::PathPose& pose : path_.poses) {
        pose.seconds -= before.seconds;
    }
}

solver::BodyPath ChangedPath::path() const {
    solver::BodyPath result = path_;
    double radius = 0;
    for (const Eigen::Vector3f& place : body_.positions) {
        radius = std::max(radius, (place.cast<double>() - vectorOf(path_.pivot)).norm());
    }
    measureTravel(result.poses, radius);
    return result;
}

} // namespace dipwright
