#include "geometry/TriangleMesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace dipwright {

namespace {

std::array<Eigen::Vector3d, 3> corners(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& index = mesh.triangles[triangle];
    return {mesh.positions[index[0]].cast<double>(), mesh.positions[index[1]].cast<double>(),
            mesh.positions[index[2]].cast<double>()};
}

// The length of this normal is twice the triangle's area.
Eigen::Vector3d areaNormal(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = corners(mesh, triangle);
    return (b - a).cross(c - a);
}

} // namespace

BoundingBox boundingBox(const TriangleMesh& mesh) {
    BoundingBox box;
    for (const auto& corners : mesh.triangles) {
        const Eigen::Vector3f& a = mesh.positions[corners[0]];
        const Eigen::Vector3f& b = mesh.positions[corners[1]];
        const Eigen::Vector3f& c = mesh.positions[corners[2]];
        box.min() = box.min().cwiseMin(a.cwiseMin(b).cwiseMin(c));
        box.max() = box.max().cwiseMax(a.cwiseMax(b).cwiseMax(c));
    }
    return box;
}

double volume(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) {
        return 0;
    }
    // Measured from a point of the mesh, so that a body far from the origin loses no precision.
    const Eigen::Vector3d origin = corners(mesh, 0)[0];
    double sixfold = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = corners(mesh, t);
        sixfold += (a - origin).dot((b - origin).cross(c - origin));
    }
    return sixfold / 6;
}

double surfaceArea(const TriangleMesh& mesh) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        area += triangleArea(mesh, t);
    }
    return area;
}

double triangleArea(const TriangleMesh& mesh, std::size_t triangle) {
    return areaNormal(mesh, triangle).norm() / 2;
}

std::array<Eigen::Vector3f, 3> cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

Eigen::Vector3f triangleNormal(const TriangleMesh& mesh, std::size_t triangle) {
    const Eigen::Vector3d normal = areaNormal(mesh, triangle);
    const double length = normal.norm();
    return length > 0 ? (normal / length).cast<float>().eval() : Eigen::Vector3f::Zero();
}

std::vector<Eigen::Vector3f> vertexNormals(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3d> sums(mesh.positions.size(), Eigen::Vector3d::Zero());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Eigen::Vector3d normal = areaNormal(mesh, t);
        for (const auto index : mesh.triangles[t]) {
            sums[index] += normal;
        }
    }
    std::vector<Eigen::Vector3f> normals(sums.size(), Eigen::Vector3f::Zero());
    std::transform(sums.begin(), sums.end(), normals.begin(), [](const Eigen::Vector3d& sum) {
        const double length = sum.norm();
        return length > 0 ? (sum / length).cast<float>().eval() : Eigen::Vector3f::Zero().eval();
    });
    return normals;
}

std::vector<std::uint32_t> oppositeEdges(const TriangleMesh& mesh) {
    // Edges are grouped by the smaller of their two position indices and sorted by the larger one.
    struct Edge {
        std::uint32_t higher, number;
        bool operator<(const Edge& other) const {
            return std::tie(higher, number) < std::tie(other.higher, other.number);
        }
    };
    const auto edgeCount = std::uint32_t(3 * mesh.triangles.size());
    const auto ends = [&](std::uint32_t edge) {
        const auto& triangle = mesh.triangles[edge / 3];
        return std::minmax(triangle[edge % 3], triangle[(edge + 1) % 3]);
    };
    std::vector<std::uint32_t> first(mesh.positions.size() + 1, 0);
    for (std::uint32_t edge = 0; edge < edgeCount; ++edge) {
        ++first[ends(edge).first + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Edge> edges(edgeCount);
    std::vector<std::uint32_t> filled(first.begin(), first.end() - 1);
    for (std::uint32_t edge = 0; edge < edgeCount; ++edge) {
        const auto [lower, higher] = ends(edge);
        edges[filled[lower]++] = {higher, edge};
    }

    std::vector<std::uint32_t> opposite(edgeCount, noEdge);
    for (std::size_t lower = 0; lower < mesh.positions.size(); ++lower) {
        const auto begin = edges.begin() + first[lower], end = edges.begin() + first[lower + 1];
        std::sort(begin, end);
        for (auto same = begin; same != end;) {
            const auto next = std::find_if(
                same, end, [&](const Edge& edge) { return edge.higher != same->higher; });
            if (next - same == 2) {
                opposite[same[0].number] = same[1].number;
                opposite[same[1].number] = same[0].number;
            }
            same = next;
        }
    }
    return opposite;
}

std::vector<std::uint32_t> connectedTriangles(const std::vector<std::uint32_t>& opposite,
                                              std::uint32_t first,
                                              const std::function<bool(std::uint32_t)>& belongs,
                                              std::vector<std::uint8_t>& seen) {
    std::vector<std::uint32_t> found{first};
    seen[first] = 1;
    for (std::size_t next = 0; next < found.size(); ++next) {
        for (std::uint32_t edge = 3 * found[next]; edge < 3 * found[next] + 3; ++edge) {
            const std::uint32_t other = opposite[edge] == noEdge ? first : opposite[edge] / 3;
            if (seen[other] == 0 && belongs(other)) {
                seen[other] = 1;
                found.push_back(other);
            }
        }
    }
    return found;
}

bool isClosed(const TriangleMesh& mesh) {
    const auto opposite = oppositeEdges(mesh);
    const auto startOf = [&](std::uint32_t edge) { return mesh.triangles[edge / 3][edge % 3]; };
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        if (opposite[edge] == noEdge || startOf(opposite[edge]) == startOf(edge)) {
            return false;
        }
    }
    return !opposite.empty();
}

TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Isometry3d& transform) {
    TriangleMesh result = mesh;
    for (auto& position : result.positions) {
        position = (transform * position.cast<double>()).cast<float>();
    }
    return result;
}

void scale(TriangleMesh& mesh, double factor) {
    for (auto& position : mesh.positions) {
        position = (position.cast<double>() * factor).cast<float>();
    }
}

double longestEdgeOf(const TriangleMesh& mesh) {
    const BoundingBox box = boundingBox(mesh);
    return (box.max().cast<double>() - box.min().cast<double>()).maxCoeff();
}

Eigen::Vector3f position(const TriangleMesh& mesh, const SurfacePoint& point) {
    const auto& index = mesh.triangles[point.triangle];
    return point.weights[0] * mesh.positions[index[0]] +
           point.weights[1] * mesh.positions[index[1]] +
           point.weights[2] * mesh.positions[index[2]];
}

} // namespace dipwright
