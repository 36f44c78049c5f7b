// Sample points spread evenly over a body's surface.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Returns one point for every `area` mm² of the surface, each representing that area; none if
// `area` is not positive. Deterministic.
std::vector<SurfacePoint> evenSamples(const TriangleMesh& mesh, double area);

} // namespace dipwright
