// Distances along a surface.
#pragma once

#include "geometry/TriangleMesh.h"

#include <limits>

namespace dipwright {

// How far each position of a mesh is from the nearest source, along the surface, mm; infinity past
// `limit`. `begin`: a position each, its distance where it is a source itself, else infinity. By
// fast marching (Kimmel & Sethian 1998, "Computing geodesic paths on manifolds"), which follows the
// edges where a triangle is obtuse: exact for straight fronts, a few hundredths too long else.
std::vector<float> surfaceDistance(const TriangleMesh& mesh, std::vector<float> begin,
                                   float limit = std::numeric_limits<float>::infinity());

} // namespace dipwright
