// Closes meshes that are open along seams that look closed. Files often store the vertices of a
// texture seam twice, with positions that differ by rounding. Welding by position does not close
// such a seam.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Returns the mesh with positions on open edges merged if they are less than 10⁻⁵ of its size
// apart. The triangles and their order stay; only their corners change. Wide openings stay open.
TriangleMesh withClosedSeams(const TriangleMesh& mesh);

} // namespace dipwright
