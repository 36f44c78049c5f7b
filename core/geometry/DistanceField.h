// The signed distance field (SDF) of a body: φ on a uniform grid in body coordinates, negative
// inside, with the surface normal as its gradient (docs/film-model.md, "Frames").
#pragma once

#include "base/Progress.h"
#include "geometry/FieldGrid.h"

#include <memory>

namespace dipwright {

class FinerFields;

// Distances are in mm. Sample (i, j, k) has the index (k·size.y + j)·size.x + i.
struct DistanceField : FieldGrid {
    std::vector<float> distance;
    // Fields of the same body with smaller cells (geometry/FinerFields.h); null: there are none.
    std::shared_ptr<const FinerFields> finer;

    // Interpolates trilinearly. Outside the grid it returns a distance that is never too large.
    double sample(const Eigen::Vector3d& position) const;
    // Returns ∇φ as the central difference of the trilinear interpolant over one cell; not
    // normalised.
    Eigen::Vector3d gradient(const Eigen::Vector3d& position) const;
};

// Builds the field on cubeGrid(), in body coordinates (FieldGrid.h). It is exact (up to float
// rounding) within three cells of the surface. Farther away its magnitude is a lower bound of the
// distance. Uses all cores; deterministic; throws Cancelled.
DistanceField buildDistanceField(const TriangleMesh& model, int resolution,
                                 const Progress& progress);

// Builds the field on the given grid, in the coordinates of `body`. `query` must have been built
// from `body`.
DistanceField buildDistanceField(const TriangleMesh& body, const SurfaceQuery& query,
                                 const FieldGrid& grid, const Progress& progress);

// Builds the field on fieldGrid(), whose cells are finer for bodies with thin parts, in body
// coordinates (FieldGrid.h). It has finer fields, for which it copies the mesh. Uses a cache on
// disk, keyed by the content of the mesh and the resolution. If the cache is damaged or cannot be
// written, the field is computed.
std::shared_ptr<const DistanceField> cachedDistanceField(const TriangleMesh& model, int resolution,
                                                         const Progress& progress);

} // namespace dipwright
