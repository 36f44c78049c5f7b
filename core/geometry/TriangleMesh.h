// Triangle meshes in millimetres, and basic queries on them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace dipwright {

using BoundingBox = Eigen::AlignedBox3f;

// Corners are in counterclockwise order seen from outside. Triangles share positions (welded).
struct TriangleMesh {
    std::vector<Eigen::Vector3f> positions; // mm
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

BoundingBox boundingBox(const TriangleMesh& mesh);
// Returns the volume in mm³, by the divergence theorem. It is meaningful only for a closed mesh.
double volume(const TriangleMesh& mesh);
double surfaceArea(const TriangleMesh& mesh);                        // mm²
double triangleArea(const TriangleMesh& mesh, std::size_t triangle); // mm²
std::array<Eigen::Vector3f, 3> cornersOf(const TriangleMesh& mesh, std::size_t triangle);
// Returns the outward unit normal; zero for a degenerate triangle.
Eigen::Vector3f triangleNormal(const TriangleMesh& mesh, std::size_t triangle);
// Returns one area-weighted unit normal for each position.
std::vector<Eigen::Vector3f> vertexNormals(const TriangleMesh& mesh);

// Edge e of triangle t runs from corner e to corner (e + 1) mod 3 and has the number 3·t + e.
inline constexpr std::uint32_t noEdge = 0xffffffffu;
// Returns for each edge number the number of the same edge in the neighbouring triangle; noEdge if
// there is no neighbour or more than one.
std::vector<std::uint32_t> oppositeEdges(const TriangleMesh& mesh);
// Returns `first` and all triangles connected to it over shared edges, through triangles for which
// `belongs` is true. `seen` holds a flag for each triangle: triangles already marked are left out,
// found ones are marked.
std::vector<std::uint32_t> connectedTriangles(const std::vector<std::uint32_t>& opposite,
                                              std::uint32_t first,
                                              const std::function<bool(std::uint32_t)>& belongs,
                                              std::vector<std::uint8_t>& seen);
// Whether every edge belongs to exactly two triangles that run along it in opposite directions.
bool isClosed(const TriangleMesh& mesh);
TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Isometry3d& transform);
void scale(TriangleMesh& mesh, double factor); // about the origin
// Returns the longest edge of the mesh's bounding box, mm.
double longestEdgeOf(const TriangleMesh& mesh);

// A place on a mesh: a triangle and the barycentric weights of its corners (they sum to 1).
struct SurfacePoint {
    std::uint32_t triangle = noTriangle;
    Eigen::Vector3f weights = Eigen::Vector3f::Zero();

    static constexpr std::uint32_t noTriangle = 0xffffffffu;
    bool isValid() const { return triangle != noTriangle; }
};
Eigen::Vector3f position(const TriangleMesh& mesh, const SurfacePoint& point);
inline SurfacePoint middleOf(std::uint32_t triangle) {
    return {triangle, Eigen::Vector3f::Constant(1.0f / 3)};
}

} // namespace dipwright
