#include "dip/PathKeys.h"

#include "dip/Pose.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

double rounded(double value, double parts) {
    return std::round(value * parts) / parts + 0.0; // + 0.0 turns −0 into 0
}

// `near`: the next pose's angles, radians. On return, the angles of this pose.
PathKey keyAt(const solver::BodyPath& path, double seconds, const TriangleMesh& posed,
              Eigen::Vector3d& near) {
    const Eigen::Isometry3d place = placeOnPath(path, travelledAfter(path, seconds));
    const Eigen::Vector3d middle(path.pivot[0], path.pivot[1], path.pivot[2]);
    const Eigen::Vector3d pivot = place * middle;
    near = anglesNear(place.linear(), near);
    PathKey key;
    key.time = Seconds(rounded(seconds, 100));
    key.depth = Millimetres(rounded(std::max(0.0, -lowestPoint(posed, place)), 100));
    key.beside = {Millimetres(rounded(pivot.x(), 100)), Millimetres(rounded(pivot.z(), 100))};
    for (int axis = 0; axis < 3; ++axis) {
        key.turn[std::size_t(axis)] = Degrees(rounded(near[axis] * 180 / pi, 10));
    }
    return key;
}

// Returns enough equal times for turns of at most 60° between them.
int keysFor(const solver::BodyPath& path) {
    constexpr int fewest = 5;
    double turned = 0;
    for (std::size_t i = 1; i < path.poses.size(); ++i) {
        turned += rotationOf(path.poses[i - 1]).angularDistance(rotationOf(path.poses[i]));
    }
    return std::max(fewest, 1 + int(std::ceil(turned / (pi / 3))));
}

} // namespace

DipPath asPoses(const TriangleMesh& posed, const Immersion& immersion,
                const ProcessSettings& process) {
    DipPath result;
    result.kind = PathKind::Poses;
    result.heading = immersion.path.heading;
    result.waterSpeed = immersion.path.waterSpeed;
    result.acceleration = immersion.path.acceleration;
    Immersion still = immersion; // the flow of the water is kept as such
    still.path.waterSpeed = {};
    still.path.acceleration.reset();
    const solver::BodyPath path = bodyPath(posed, still, process);
    if (path.isStraightDown()) {
        const double height = boundingBox(posed).sizes().y();
        PathKey last{
            Seconds(
                rounded((dipDepth(process, height) + startHeight) / process.dipSpeed.value(), 100)),
            std::nullopt};
        result.keys = {PathKey(), last};
        return result;
    }
    const double end = path.poses.back().seconds;
    Eigen::Vector3d near(0, 0, 0);
    const int last = keysFor(path) - 1;
    for (int i = last; i >= 0; --i) { // backwards, since the last one is not turned
        result.keys.insert(result.keys.begin(), keyAt(path, end * i / last, posed, near));
    }
    result.keys.front().depth = Millimetres(0);
    result.keys.back().depth.reset();
    result.keys.back().turn = {};
    return result;
}

std::vector<double> timesOfKeys(const TriangleMesh& posed, const Immersion& immersion,
                                const ProcessSettings& process) {
    std::vector<double> times;
    for (const PathKey& key : immersion.path.keys) {
        times.push_back(key.time.value());
    }
    if (immersion.path.acceleration) {
        Immersion still = immersion; // without a flow, a limit of the acceleration keeps the way
        still.path.waterSpeed = {};
        const solver::BodyPath limited = bodyPath(posed, still, process);
        still.path.acceleration.reset();
        const solver::BodyPath planned = bodyPath(posed, still, process);
        for (double& time : times) {
            time = secondsOnPath(limited, travelledAfter(planned, time));
        }
    }
    return times;
}

PathKey middleKey(const PathKey& before, const PathKey& after, Millimetres depth) {
    const auto middle = [](auto one, auto other) { return one + (other - one) / 2; };
    PathKey key;
    key.time = middle(before.time, after.time);
    key.depth = middle(before.depth.value_or(depth), after.depth.value_or(depth));
    for (std::size_t part = 0; part < 2; ++part) {
        key.beside[part] = middle(before.beside[part], after.beside[part]);
    }
    for (std::size_t part = 0; part < 3; ++part) {
        key.turn[part] = middle(before.turn[part], after.turn[part]);
    }
    return key;
}

} // namespace dipwright
