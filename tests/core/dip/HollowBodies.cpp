#include "HollowBodies.h"

#include "base/Units.h"

#include <cmath>

namespace dipwright::test {

TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile, int segments) {
    TriangleMesh mesh;
    const auto count = std::uint32_t(segments);
    for (const Eigen::Vector2d& point : profile) {
        for (std::uint32_t segment = 0; segment < count; ++segment) {
            const double angle = 2 * pi * segment / segments;
            mesh.positions.push_back(
                Eigen::Vector3d(point.x() * std::cos(angle), point.y(), point.x() * std::sin(angle))
                    .cast<float>());
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::uint32_t segment = 0; segment < count; ++segment) {
            const std::uint32_t next = (segment + 1) % count;
            const std::uint32_t below = ring * count;
            const std::uint32_t above = below + count;
            mesh.triangles.push_back({below + segment, above + segment, above + next});
            mesh.triangles.push_back({below + segment, above + next, below + next});
        }
    }
    return mesh;
}

TriangleMesh bowl(double holeRadius) {
    constexpr int steps = 24;
    std::vector<Eigen::Vector2d> profile;
    for (const bool isInner : {true, false}) {
        const double radius = isInner ? bowlRadius - bowlWall : bowlRadius;
        const double top = std::acos(holeRadius / radius);
        for (int step = 0; step <= steps; ++step) {
            const double angle = top * (isInner ? steps - step : step) / steps;
            profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
    }
    if (holeRadius > 0) {
        profile.push_back(profile.front());
    }
    return turned(profile, 96);
}

TriangleMesh cup() {
    return turned({{0, 0}, {30, 0}, {30, 40}, {27, 40}, {27, 3}, {0, 3}}, 96);
}

} // namespace dipwright::test
