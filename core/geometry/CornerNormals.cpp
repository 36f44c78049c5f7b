#include "geometry/CornerNormals.h"

#include "base/Units.h"
#include "parallel/ParallelFor.h"

#include <cmath>

namespace dipwright {
namespace {

// Faces whose normals differ by less than this angle form one smooth surface.
const auto creaseCosine = float(std::cos(radians(Degrees(35))));

} // namespace

CornerNormals cornerNormals(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3f> faces(mesh.triangles.size());
    std::vector<float> areas(mesh.triangles.size());
    std::vector<std::uint32_t> first(mesh.positions.size() + 1, 0); // start in `around`
    for (std::size_t i = 0; i < faces.size(); ++i) {
        faces[i] = triangleNormal(mesh, i);
        areas[i] = float(triangleArea(mesh, i));
        for (std::uint32_t position : mesh.triangles[i]) {
            ++first[position + 1];
        }
    }
    for (std::size_t i = 1; i < first.size(); ++i) {
        first[i] += first[i - 1];
    }
    std::vector<std::uint32_t> around(3 * faces.size());
    std::vector<std::uint32_t> next = first;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::uint32_t position : mesh.triangles[i]) {
            around[next[position]++] = std::uint32_t(i);
        }
    }
    CornerNormals normals(faces.size());
    parallelFor(std::size_t(0), faces.size(), [&](std::size_t i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t position = mesh.triangles[i][corner];
            Eigen::Vector3f sum = Eigen::Vector3f::Zero();
            for (std::uint32_t at = first[position]; at < first[position + 1]; ++at) {
                const std::uint32_t other = around[at];
                if (faces[i].dot(faces[other]) >= creaseCosine) {
                    sum += areas[other] * faces[other];
                }
            }
            normals[i][corner] = sum.squaredNorm() > 0 ? sum.normalized() : faces[i];
        }
    });
    return normals;
}

Eigen::Vector3f normalAt(const CornerNormals& normals, const SurfacePoint& point) {
    const auto& corners = normals[point.triangle];
    return (point.weights[0] * corners[0] + point.weights[1] * corners[1] +
            point.weights[2] * corners[2])
        .normalized();
}

} // namespace dipwright
