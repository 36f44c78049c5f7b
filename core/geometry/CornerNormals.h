// Normals of a mesh that is looked at as the smooth body that it stands for.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Of each triangle's corners: smooth over gentle edges, sharp at creases.
using CornerNormals = std::vector<std::array<Eigen::Vector3f, 3>>;
CornerNormals cornerNormals(const TriangleMesh& mesh);
// At a place on the surface; unit.
Eigen::Vector3f normalAt(const CornerNormals& normals, const SurfacePoint& point);

} // namespace dipwright
