#include "geometry/OpenSeams.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace dipwright {
namespace {

constexpr float largestGap = 1e-5f; // relative to the mesh's longest side

// Returns the positions on edges that only one triangle has, in ascending order.
std::vector<std::uint32_t> onOpenEdges(const TriangleMesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& corners : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.push_back(std::minmax(corners[k], corners[(k + 1) % 3]));
        }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::uint32_t> positions;
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t next = first + 1;
        while (next < edges.size() && edges[next] == edges[first]) {
            ++next;
        }
        if (next == first + 1) {
            positions.push_back(edges[first].first);
            positions.push_back(edges[first].second);
        }
        first = next;
    }
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
}

} // namespace

TriangleMesh withClosedSeams(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> open = onOpenEdges(mesh);
    if (open.empty()) {
        return mesh;
    }
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& position : mesh.positions) {
        box.extend(position);
    }
    const float near = largestGap * box.sizes().maxCoeff();
    // Sweep in an oblique direction, because seams and rims run along the axes and share
    // coordinates.
    const Eigen::Vector3f sweepDirection = Eigen::Vector3f(0.53f, 0.62f, 0.58f).normalized();
    const auto along = [&](std::uint32_t position) {
        return sweepDirection.dot(mesh.positions[position]);
    };
    std::stable_sort(open.begin(), open.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
    std::vector<std::uint32_t> one(mesh.positions.size());
    for (std::uint32_t position = 0; position < one.size(); ++position) {
        one[position] = position;
    }
    for (std::size_t later = 1; later < open.size(); ++later) {
        for (std::size_t k = later; k-- > 0 && along(open[later]) - along(open[k]) <= near;) {
            if ((mesh.positions[open[later]] - mesh.positions[open[k]]).norm() <= near) {
                one[open[later]] = one[open[k]];
                break;
            }
        }
    }
    TriangleMesh closed = mesh;
    for (auto& corners : closed.triangles) {
        for (std::uint32_t& corner : corners) {
            corner = one[corner];
        }
    }
    return closed;
}

} // namespace dipwright
