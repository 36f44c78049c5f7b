#include "model/TexturedMesh.h"

#include <bit>
#include <cmath>

namespace dipwright {

namespace {

// Compares bits, so that corners without coordinates (NaN) are equal too.
bool isSame(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    return std::bit_cast<std::uint32_t>(a.x()) == std::bit_cast<std::uint32_t>(b.x()) &&
           std::bit_cast<std::uint32_t>(a.y()) == std::bit_cast<std::uint32_t>(b.y());
}

// Whether the texture continues across the edge from one triangle to the other.
bool isContinuous(const TexturedMesh& mesh, std::uint32_t edge, std::uint32_t opposite) {
    const std::uint32_t here = edge / 3, there = opposite / 3;
    if (mesh.material[here] != mesh.material[there]) {
        return false;
    }
    const std::uint32_t start = edge % 3, end = (edge + 1) % 3;
    std::uint32_t otherStart = opposite % 3, otherEnd = (opposite + 1) % 3;
    if (mesh.mesh.triangles[here][start] != mesh.mesh.triangles[there][otherStart]) {
        std::swap(otherStart, otherEnd);
    }
    const auto& uvHere = mesh.textureCoordinates[here];
    const auto& uvThere = mesh.textureCoordinates[there];
    return isSame(uvHere[start], uvThere[otherStart]) && isSame(uvHere[end], uvThere[otherEnd]);
}

} // namespace

bool SurfaceAppearance::hasTextureCoordinates(std::size_t triangle) const {
    for (const auto& corner : textureCoordinates[triangle]) {
        if (!std::isfinite(corner.x()) || !std::isfinite(corner.y())) {
            return false;
        }
    }
    return true;
}

Eigen::Vector2f SurfaceAppearance::textureCoordinate(const SurfacePoint& point) const {
    const auto& corners = textureCoordinates[point.triangle];
    return point.weights[0] * corners[0] + point.weights[1] * corners[1] +
           point.weights[2] * corners[2];
}

std::vector<std::uint32_t> findCharts(const TexturedMesh& mesh) {
    constexpr std::uint32_t unknown = 0xffffffffu;
    const auto opposite = oppositeEdges(mesh.mesh);
    std::vector<std::uint32_t> chart(mesh.mesh.triangles.size(), unknown);
    std::vector<std::uint32_t> toVisit;
    std::uint32_t charts = 0;
    for (std::uint32_t seed = 0; seed < chart.size(); ++seed) {
        if (chart[seed] != unknown) {
            continue;
        }
        chart[seed] = charts;
        toVisit.push_back(seed);
        while (!toVisit.empty()) {
            const std::uint32_t triangle = toVisit.back();
            toVisit.pop_back();
            for (std::uint32_t edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
                if (opposite[edge] != noEdge && chart[opposite[edge] / 3] == unknown &&
                    isContinuous(mesh, edge, opposite[edge])) {
                    chart[opposite[edge] / 3] = charts;
                    toVisit.push_back(opposite[edge] / 3);
                }
            }
        }
        ++charts;
    }
    return chart;
}

} // namespace dipwright
