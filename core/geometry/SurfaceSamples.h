// Points spread evenly over a body, to measure it with.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// One point for every `area` mm² of the surface, each standing for as much; none where that is no
// area. Always the same for the same mesh.
std::vector<SurfacePoint> evenSamples(const TriangleMesh& mesh, double area);

} // namespace dipwright
