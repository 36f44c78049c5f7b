#include "SectionPlane.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double reachPixels = 9;
constexpr float beyond = 1e6f; // mm, farther than any drawn place

} // namespace

Eigen::Vector3f SectionPlane::inward() const {
    return (after ? 1.0f : -1.0f) * Eigen::Vector3f::Unit(axis);
}

std::array<Eigen::Vector3f, 4> SectionPlane::corners() const {
    const int right = (axis + 1) % 3, up = (axis + 2) % 3;
    std::array<Eigen::Vector3f, 4> found;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const bool isRight = corner == 1 || corner == 2;
        found[corner][axis] = float(place);
        found[corner][right] = isRight ? extent.max()[right] : extent.min()[right];
        found[corner][up] = corner >= 2 ? extent.max()[up] : extent.min()[up];
    }
    return found;
}

ViewRay SectionPlane::shownPart(ViewRay ray) const {
    const Eigen::Vector3f normal = inward();
    const float depth = normal[axis] * (ray.origin[axis] - float(place));
    if (depth < 0) {
        const float speed = normal.dot(ray.direction);
        ray.origin += (speed > 0 ? std::min(-depth / speed, beyond) : beyond) * ray.direction;
    }
    return ray;
}

std::optional<Eigen::Vector3f> SectionPlane::frameAt(QPointF position,
                                                     const ViewProjection& shown) const {
    constexpr int steps = 200; // points along one side of the frame
    const std::array<Eigen::Vector3f, 4> corner = corners();
    std::optional<Eigen::Vector3f> nearest;
    double least = reachPixels;
    for (std::size_t side = 0; side < 4; ++side) {
        for (int step = 0; step < steps; ++step) {
            const Eigen::Vector3f point =
                corner[side] + float(step) / steps * (corner[(side + 1) % 4] - corner[side]);
            const QPointF off = shown.positionOf(point) - position;
            const double distance = std::hypot(off.x(), off.y());
            if (distance < least) {
                least = distance;
                nearest = point;
            }
        }
    }
    return nearest;
}

} // namespace dipwright
