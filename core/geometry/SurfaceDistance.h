// Distances along a surface.
#pragma once

#include "geometry/TriangleMesh.h"

#include <array>
#include <limits>
#include <vector>

namespace dipwright {

// The corners of triangles that lie each by itself, unfolded from a surface.
using UnfoldedTriangles = std::vector<std::array<Eigen::Vector3f, 3>>;

// How far each position of a mesh is from the nearest source, along the surface, mm; infinity past
// `limit`. `begin`: a position each, its distance where it is a source itself, else infinity.
// `measured`: where the corners of each triangle are to lie for its lengths to count otherwise than
// in mm of the mesh; none: where they do. Distances, the sources' and the limit are then in what
// counts. By fast marching (Kimmel & Sethian 1998, "Computing geodesic paths on manifolds"), which
// follows the edges where a triangle is obtuse: exact for straight fronts, a few hundredths too
// long else.
std::vector<float> surfaceDistance(const TriangleMesh& mesh, std::vector<float> begin,
                                   float limit = std::numeric_limits<float>::infinity(),
                                   const UnfoldedTriangles& measured = {});

} // namespace dipwright
