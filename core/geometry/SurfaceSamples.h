// Points spread evenly over a body, to measure it with.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// One point for every `area` (> 0) mm² of the surface, each standing for as much. Always the same
// for the same mesh.
std::vector<SurfacePoint> evenSamples(const TriangleMesh& mesh, double area);

} // namespace dipwright
