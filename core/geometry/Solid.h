// Tells whether a mesh bounds a solid, so that every point is clearly inside or outside.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Whether as many triangles run along each edge in one direction as in the other. Closed meshes
// (isClosed()) bound a solid, and so do parts that touch at edges.
bool boundsSolid(const TriangleMesh& mesh);

} // namespace dipwright
