// Reduces the number of a mesh's triangles for files that are sent and shown.
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"

namespace dipwright {

struct ReducedMesh {
    TriangleMesh mesh;
    double distance = 0; // largest distance between the two surfaces, mm; measured from both
};

// Returns the surface with about `triangles` triangles, at most `tolerance` mm away. If it would be
// further away, keeps twice as many triangles, and so on; in the end all. A mesh with fewer
// triangles is returned unchanged. Works for open meshes, too. Uses vtkQuadricDecimation (Garland &
// Heckbert 1997, "Surface simplification using quadric error metrics"). Deterministic. Throws
// Cancelled.
ReducedMesh reducedMesh(const TriangleMesh& mesh, std::size_t triangles, double tolerance,
                        const CancelToken& cancelToken);

} // namespace dipwright
