// Makes one mesh of several, for bodies of several parts.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright::test {

// Returns `mesh` and a copy of `part` that is moved by `shift`.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& part,
                           const Eigen::Vector3f& shift = Eigen::Vector3f::Zero()) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const Eigen::Vector3f& position : part.positions) {
        mesh.positions.push_back(position + shift);
    }
    for (const auto& [a, b, c] : part.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return mesh;
}

} // namespace dipwright::test
