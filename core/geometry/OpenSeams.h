// Closes the seams of a mesh that look closed but are open. Files often store the vertices of a
// texture seam twice, with positions that differ by rounding errors. Welding by position does not
// close such a seam.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Returns the mesh with positions on open edges merged if the gap is less than 10⁻⁵ of the mesh's
// longest side. The triangles and their order stay; only their corners change. Wide openings stay
// open.
TriangleMesh withClosedSeams(const TriangleMesh& mesh);

} // namespace dipwright
