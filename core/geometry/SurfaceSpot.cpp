#include "geometry/SurfaceSpot.h"

#include "geometry/SurfaceDistance.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace dipwright {
namespace {

// The largest angle between the normals of the first triangle and any other, degrees.
constexpr double faceAngle = 15;

} // namespace

std::vector<float> distanceFrom(const TriangleMesh& mesh, const SurfacePoint& place, float limit) {
    const Eigen::Vector3f at = position(mesh, place);
    std::vector<float> begin(mesh.positions.size(), std::numeric_limits<float>::infinity());
    for (const std::uint32_t corner : mesh.triangles[place.triangle]) {
        begin[corner] = (mesh.positions[corner] - at).norm();
    }
    return surfaceDistance(mesh, std::move(begin), limit);
}

std::vector<std::uint32_t> trianglesWithin(const TriangleMesh& mesh, const SurfacePoint& middle,
                                           float radius) {
    const std::vector<float> distance = distanceFrom(mesh, middle, radius);
    std::vector<std::uint32_t> found;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        if ((distance[a] + distance[b] + distance[c]) / 3 <= radius ||
            triangle == middle.triangle) {
            found.push_back(triangle);
        }
    }
    return found;
}

std::vector<std::uint32_t> faceAround(const TriangleMesh& mesh, std::uint32_t triangle) {
    return faceAround(mesh, oppositeEdges(mesh), triangle);
}

std::vector<std::uint32_t> faceAround(const TriangleMesh& mesh,
                                      const std::vector<std::uint32_t>& opposite,
                                      std::uint32_t triangle) {
    const Eigen::Vector3f normal = triangleNormal(mesh, triangle);
    const auto least = float(std::cos(faceAngle * std::numbers::pi / 180));
    std::vector<std::uint8_t> seen(mesh.triangles.size());
    return connectedTriangles(
        opposite, triangle,
        [&](std::uint32_t other) { return triangleNormal(mesh, other).dot(normal) >= least; },
        seen);
}

} // namespace dipwright
