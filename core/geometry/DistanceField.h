// The signed distance field (SDF) of a body: φ on a uniform grid in body coordinates, negative
// inside, with the surface normal as its gradient (docs/film-model.md, "Frames").
#pragma once

#include "base/Progress.h"
#include "geometry/FieldGrid.h"

#include <memory>

namespace dipwright {

// Sample (i, j, k) has the index (k·size.y + j)·size.x + i; mm.
struct DistanceField : FieldGrid {
    std::vector<float> distance;

    // Trilinear; outside the grid a distance that is never too large.
    double sample(const Eigen::Vector3d& position) const;
    // ∇φ by the trilinear interpolant's central difference over one cell; not normalised.
    Eigen::Vector3d gradient(const Eigen::Vector3d& position) const;
};

// On cubeGrid(). Exact (to float rounding) within three cells of the surface; farther away a bound
// that is never too large in magnitude. All cores; deterministic; throws Cancelled.
DistanceField buildDistanceField(const TriangleMesh& body, int resolution,
                                 const Progress& progress);

// The same on a grid; `query`: of `body`.
DistanceField buildDistanceField(const TriangleMesh& body, const SurfaceQuery& query,
                                 const FieldGrid& grid, const Progress& progress);

// The same on fieldGrid(), with finer cells where the body's thinnest part needs them, through a
// cache on disk, keyed by the content of the mesh and the resolution. A damaged or unwritable cache
// is as good as none.
std::shared_ptr<const DistanceField> cachedDistanceField(const TriangleMesh& body, int resolution,
                                                         const Progress& progress);

} // namespace dipwright
