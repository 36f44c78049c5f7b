// Reduces the number of a closed surface's triangles without moving the surface noticeably, so that
// slicers read it quickly.
#pragma once

#include "base/Progress.h"
#include "geometry/SurfaceQuery.h"

namespace dipwright {

struct ReducedSurface {
    TriangleMesh mesh;
    double distance = 0; // largest distance between the two surfaces, mm; measured from both
};

// Returns the surface with about a tenth of its triangles. The result is closed
// (isClosedSurface()), does not cross itself, and is at most `tolerance` mm away from `surface`.
// If it is not, fewer triangles are removed, and in the end none. Uses vtkDecimatePro (Schroeder,
// Zarge & Lorensen, SIGGRAPH 1992), which keeps the topology; the distance is measured
// independently of it, at points at most `spacing` mm apart on average. Deterministic. Throws
// Cancelled.
ReducedSurface reducedSurface(const TriangleMesh& surface, double tolerance, double spacing,
                              const Progress& progress);

// Whether an edge of the mesh passes through one of its triangles by more than 0.001 mm. Checked by
// rays along all edges. `query` is a query on this mesh.
bool crossesItself(const TriangleMesh& mesh, const SurfaceQuery& query);

} // namespace dipwright
