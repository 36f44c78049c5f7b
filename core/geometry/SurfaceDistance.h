// Distances along a surface.
#pragma once

#include "geometry/TriangleMesh.h"

#include <array>
#include <limits>
#include <vector>

namespace dipwright {

// The corners of triangles that are unfolded from a surface, each triangle separately.
using UnfoldedTriangles = std::vector<std::array<Eigen::Vector3f, 3>>;

// Returns the distance along the surface from each position of a mesh to the nearest source, mm;
// infinity beyond `limit`. `begin` holds for each position its start distance if it is a source,
// else infinity. `measured` optionally replaces the triangles' corners, so that lengths are
// measured in another metric than mm on the mesh. Distances, start distances and the limit are then
// in the other metric. Uses fast marching (Kimmel & Sethian 1998, "Computing geodesic paths on
// manifolds"), which follows the edges of obtuse triangles. It is exact for straight fronts and
// otherwise a few per cent too long.
std::vector<float> surfaceDistance(const TriangleMesh& mesh, std::vector<float> begin,
                                   float limit = std::numeric_limits<float>::infinity(),
                                   const UnfoldedTriangles& measured = {});

} // namespace dipwright
