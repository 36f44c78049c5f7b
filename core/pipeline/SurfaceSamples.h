// Points spread evenly over a body, to measure areas with.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

struct SurfaceSample {
    SurfacePoint point;
    double area = 0; // mm² that it stands for
};

// About `count` points, at least one a triangle; the areas sum to that of the mesh. Always the same
// for the same mesh.
std::vector<SurfaceSample> spreadOverSurface(const TriangleMesh& mesh, int count);

} // namespace dipwright
