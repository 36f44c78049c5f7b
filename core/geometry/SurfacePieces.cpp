#include "geometry/SurfacePieces.h"

#include <algorithm>

namespace dipwright {

std::vector<SurfacePiece> surfacePieces(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& opposite,
                                        const std::function<bool(std::uint32_t)>& belongs,
                                        double leastArea) {
    const auto middle = [&](std::uint32_t triangle) { return position(mesh, middleOf(triangle)); };
    std::vector<std::uint8_t> seen(mesh.triangles.size());
    std::vector<SurfacePiece> pieces;
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        if (seen[start] != 0 || !belongs(start)) {
            continue;
        }
        const std::vector<std::uint32_t> triangles =
            connectedTriangles(opposite, start, belongs, seen);
        double area = 0;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const std::uint32_t triangle : triangles) {
            area += triangleArea(mesh, triangle);
            sum += triangleArea(mesh, triangle) * middle(triangle).cast<double>();
        }
        if (area < leastArea) {
            continue;
        }
        const Eigen::Vector3f mean = (sum / area).cast<float>();
        const std::uint32_t nearest = *std::min_element(
            triangles.begin(), triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
                return (middle(a) - mean).squaredNorm() < (middle(b) - mean).squaredNorm();
            });
        pieces.push_back({area, nearest});
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a.area > b.area; });
    return pieces;
}

} // namespace dipwright
