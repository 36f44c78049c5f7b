#include "geometry/TriangleMesh.h"

#include <algorithm>

namespace dipwright {

namespace {

std::array<Eigen::Vector3d, 3> corners(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& index = mesh.triangles[triangle];
    return {mesh.positions[index[0]].cast<double>(), mesh.positions[index[1]].cast<double>(),
            mesh.positions[index[2]].cast<double>()};
}

// Its length is twice the triangle's area.
Eigen::Vector3d areaNormal(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = corners(mesh, triangle);
    return (b - a).cross(c - a);
}

} // namespace

BoundingBox boundingBox(const TriangleMesh& mesh) {
    BoundingBox box;
    for (const auto& triangle : mesh.triangles) {
        for (const auto index : triangle) {
            box.extend(mesh.positions[index]);
        }
    }
    return box;
}

double volume(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) {
        return 0;
    }
    // Measured from a point of the mesh, so that a body far from the origin loses no digits.
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

bool isClosed(const TriangleMesh& mesh) {
    // Every directed edge, and every reversed one: in a closed mesh the two lists are the same and
    // hold nothing twice.
    std::vector<std::uint64_t> edges, reversed;
    edges.reserve(3 * mesh.triangles.size());
    reversed.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint64_t from = triangle[corner];
            const std::uint64_t to = triangle[(corner + 1) % 3];
            edges.push_back(from << 32 | to);
            reversed.push_back(to << 32 | from);
        }
    }
    std::sort(edges.begin(), edges.end());
    std::sort(reversed.begin(), reversed.end());
    return !edges.empty() && edges == reversed &&
           std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Isometry3d& transform) {
    TriangleMesh result = mesh;
    for (auto& position : result.positions) {
        position = (transform * position.cast<double>()).cast<float>();
    }
    return result;
}

Eigen::Vector3f position(const TriangleMesh& mesh, const SurfacePoint& point) {
    const auto& index = mesh.triangles[point.triangle];
    return point.weights[0] * mesh.positions[index[0]] +
           point.weights[1] * mesh.positions[index[1]] +
           point.weights[2] * mesh.positions[index[2]];
}

} // namespace dipwright
