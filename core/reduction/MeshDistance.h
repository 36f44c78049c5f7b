// Measures how far one mesh is from another.
#pragma once

#include "geometry/SurfaceQuery.h"

namespace dipwright {

// Returns the largest distance from `from` to the mesh of `to`, in mm; 0 for an empty mesh.
// Measured at the positions of `from`, at the middles of its triangles, and at points at most
// `spacing` mm apart on average. Distances up to `likely` mm are found fastest. Uses all cores.
double largestDistance(const TriangleMesh& from, const SurfaceQuery& to, double likely,
                       double spacing);

} // namespace dipwright
