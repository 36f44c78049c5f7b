#include "inspection/Lens.h"

#include <cmath>

namespace dipwright {

LensPlane::LensPlane(QSize picture)
    : middle_(picture.width() / 2.0, picture.height() / 2.0), unit_(middle_.norm()) {}

Eigen::Vector2d LensPlane::inUnits(const Eigen::Vector2d& pixel) const {
    return (pixel - middle_) / unit_;
}

Eigen::Vector2d LensPlane::inPixels(const Eigen::Vector2d& place) const {
    return place * unit_ + middle_;
}

Eigen::Vector2d distorted(const Eigen::Vector2d& place, const Lens& lens) {
    const double square = place.squaredNorm();
    return place * (1 + square * (lens.k1 + square * lens.k2));
}

Eigen::Vector2d undistorted(const Eigen::Vector2d& seen, const Lens& lens) {
    // Solves r (1 + k1 r² + k2 r⁴) = |seen| along the ray by Newton's method from |seen|.
    const double target = seen.norm();
    double r = target;
    for (int round = 0; round < 30; ++round) {
        const double square = r * r;
        const double slope = 1 + square * (3 * lens.k1 + 5 * square * lens.k2);
        if (slope < 0.1) {
            return seen; // beyond the radius at which the distortion folds back
        }
        const double change = (r * (1 + square * (lens.k1 + square * lens.k2)) - target) / slope;
        r -= change;
        if (std::abs(change) < 1e-14) {
            break;
        }
    }
    return target > 0 ? Eigen::Vector2d(seen * (r / target)) : seen;
}

} // namespace dipwright
