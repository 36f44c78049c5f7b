// Finds the pose of a body on its path (FilmSolver.h, BodyPath).
#pragma once

#include "common/BodyFrame.h"
#include "common/Functions.h"

#include <dipwright/FilmSolver.h>

#include <cmath>

namespace dipwright::numerics {

// The poses of a path, in the memory of the device that uses them. The owner keeps them alive. No
// poses: the body moves straight down.
struct PathView {
    const solver::PathPose* poses = nullptr;
    int count = 0;
    double pivot[3] = {}; // body coordinates
};

inline PathView pathView(const solver::BodyPath& path) {
    return {
        path.poses.data(), int(path.poses.size()), {path.pivot[0], path.pivot[1], path.pivot[2]}};
}

namespace detail {

// Returns the index of the pose that ends the part of the path at `travelled`.
DIPWRIGHT_HOST_DEVICE inline int poseAfter(const PathView& path, double travelled) {
    int first = 1, last = path.count - 1;
    while (first < last) {
        const int middle = (first + last) / 2;
        if (path.poses[middle].travelled < travelled) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    return first;
}

// Returns which share (0 to 1) of the distance from pose `after − 1` to pose `after` has been
// travelled.
DIPWRIGHT_HOST_DEVICE inline double shareBetween(const PathView& path, int after,
                                                 double travelled) {
    const double begin = path.poses[after - 1].travelled, end = path.poses[after].travelled;
    return std::fmin(std::fmax((travelled - begin) / (end - begin), 0.0), 1.0);
}

} // namespace detail

// Returns the time since the dip began, in seconds. The path must have poses.
DIPWRIGHT_HOST_DEVICE inline double secondsOnPath(const PathView& path, double travelled) {
    const int after = detail::poseAfter(path, travelled);
    const double begin = path.poses[after - 1].seconds, end = path.poses[after].seconds;
    return begin + detail::shareBetween(path, after, travelled) * (end - begin);
}

// Returns the frame of the body after it has travelled `travelled` mm. The path must have poses.
// Interpolates the rotation as a quaternion at constant angular speed (Shoemake 1985).
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_CALLED BodyFrame<Real> frameOnPath(const PathView& path,
                                                                   double travelled) {
    const int after = detail::poseAfter(path, travelled);
    const double share = detail::shareBetween(path, after, travelled);
    const solver::PathPose &from = path.poses[after - 1], &to = path.poses[after];
    const double* a = &from.rotation[0];
    const double* b = &to.rotation[0];
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    const double angle = angleOf(std::fmin(std::fabs(cosine), 1.0));
    double weightA = 1 - share, weightB = share;
    constexpr double leastAngle = 1e-6; // below it, the sines' ratio is the share itself
    if (angle > leastAngle) {
        weightA = sineOf((1 - share) * angle) / sineOf(angle);
        weightB = sineOf(share * angle) / sineOf(angle);
    }
    weightB = cosine < 0 ? -weightB : weightB;
    double q[4];
    double square = 0;
    for (int i = 0; i < 4; ++i) {
        q[i] = weightA * a[i] + weightB * b[i];
        square += q[i] * q[i];
    }
    const double s = 2 / square;
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double rows[3][3] = {{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
                               {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
                               {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}};
    BodyFrame<Real> frame;
    double translation[3];
    const double* begin = &from.pivot[0];
    const double* end = &to.pivot[0];
    for (int row = 0; row < 3; ++row) {
        frame.rows[row] = {Real(rows[row][0]), Real(rows[row][1]), Real(rows[row][2])};
        translation[row] = begin[row] + share * (end[row] - begin[row]);
        for (int i = 0; i < 3; ++i) {
            translation[row] -= rows[row][i] * path.pivot[i];
        }
    }
    frame.translation = {Real(translation[0]), Real(translation[1]), Real(translation[2])};
    return frame;
}

} // namespace dipwright::numerics
