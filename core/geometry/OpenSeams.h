// Meshes that are cut open where they look whole: files often have a texture's seam twice, and
// with its places a rounding apart, so that welding by position does not close it.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// The mesh with positions on open edges that are hardly apart (10⁻⁵ of its size) made one. The same
// triangles in the same order, but for their corners; wide openings stay open.
TriangleMesh withClosedSeams(const TriangleMesh& mesh);

} // namespace dipwright
