#include "share/ShareMarks.h"

#include "geometry/SurfaceDistance.h"
#include "geometry/SurfaceQuery.h"

#include <cmath>
#include <numbers>

namespace dipwright {
namespace {

// Constants of ours (docs/film-model.md, "Two dips, one body").
constexpr double told = 1e5;     // the cost of a mm² that the user has given to the other dip
constexpr float avoided = 20;    // times as visible
constexpr float allowed = 0.05f; // times as visible
constexpr double faceAngle = 15; // degrees by which a face's normals differ at most

// The triangles with a corner within `radius` mm along the surface, and the first itself.
std::vector<std::uint32_t> spot(const TriangleMesh& mesh, const SurfacePoint& middle,
                                float radius) {
    const Eigen::Vector3f place = position(mesh, middle);
    std::vector<float> begin(mesh.positions.size(), std::numeric_limits<float>::infinity());
    for (const std::uint32_t corner : mesh.triangles[middle.triangle]) {
        begin[corner] = (mesh.positions[corner] - place).norm();
    }
    const std::vector<float> distance = surfaceDistance(mesh, std::move(begin), radius);
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

// The triangles that hang together with the first and face as it does.
std::vector<std::uint32_t> face(const TriangleMesh& mesh, std::uint32_t first) {
    const Eigen::Vector3f normal = triangleNormal(mesh, first);
    const auto least = float(std::cos(faceAngle * std::numbers::pi / 180));
    std::vector<std::uint8_t> seen(mesh.triangles.size());
    return connectedTriangles(
        oppositeEdges(mesh), first,
        [&](std::uint32_t other) { return triangleNormal(mesh, other).dot(normal) >= least; },
        seen);
}

} // namespace

void obeyMarks(const TriangleMesh& mesh, const std::vector<ShareMark>& marks,
               std::vector<std::array<double, 2>>& costs, std::vector<float>& weights) {
    if (marks.empty()) {
        return;
    }
    const SurfaceQuery query(mesh);
    const std::vector<std::array<double, 2>> free = costs;
    const std::vector<float> plain = weights;
    for (const ShareMark& mark : marks) {
        const Eigen::Vector3f place(float(mark.place[0].value()), float(mark.place[1].value()),
                                    float(mark.place[2].value()));
        const SurfacePoint middle = query.closest(place).point;
        const auto radius = float(mark.radius.value());
        for (const std::uint32_t triangle :
             radius > 0 ? spot(mesh, middle, radius) : face(mesh, middle.triangle)) {
            const double area = triangleArea(mesh, triangle);
            switch (mark.kind) {
            case ShareMarkKind::First:
                costs[triangle] = {free[triangle][0], free[triangle][1] + told * area};
                break;
            case ShareMarkKind::Second:
                costs[triangle] = {free[triangle][0] + told * area, free[triangle][1]};
                break;
            case ShareMarkKind::Avoid:
                weights[triangle] = avoided * plain[triangle];
                break;
            case ShareMarkKind::Allow:
                weights[triangle] = allowed * plain[triangle];
                break;
            }
        }
    }
}

} // namespace dipwright
