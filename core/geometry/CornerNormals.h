// Normals of the smooth body that a mesh approximates.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// One normal for each corner of each triangle: smooth over gentle edges, sharp at creases.
using CornerNormals = std::vector<std::array<Eigen::Vector3f, 3>>;
CornerNormals cornerNormals(const TriangleMesh& mesh);
// Returns the unit normal at a place on the surface.
Eigen::Vector3f normalAt(const CornerNormals& normals, const SurfacePoint& point);

} // namespace dipwright
