// Where the samples of a body's distance field lie: as many as the user says or, where the body has
// parts too thin for these, as many as its thinnest parts need (docs/film-model.md, "The distance
// field's cells").
#pragma once

#include "geometry/SurfaceQuery.h"

namespace dipwright {

// Samples (i, j, k) at origin + spacing·(i, j, k); mm.
struct FieldGrid {
    std::array<int, 3> size{};
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double spacing = 0;

    std::size_t sampleCount() const;
};

// `resolution` (32 … 512) samples along each edge of a cube that leaves at least two cells free
// round the body. Throws Error on another resolution or a body without extent.
FieldGrid cubeGrid(const TriangleMesh& body, int resolution);

// How thick the thinnest parts of a body are, mm: a hundredth of its surface lies on plates that
// are thinner; infinite where less than that lies on plates. A plate has faces on both sides that
// are parallel to within 37°, so that what tapers to an edge is none. `query`: of `body`.
double thinnestPart(const TriangleMesh& body, const SurfaceQuery& query);

// Whether a field finds plates that thick.
bool isFineEnough(const FieldGrid& grid, double thinnest);

// cubeGrid() where that is fine enough for parts of this thickness; else a box with finer cells, as
// fine as they need or as mostFieldSamples allow.
FieldGrid fieldGrid(const TriangleMesh& body, int resolution, double thinnest);

inline constexpr std::size_t mostFieldSamples = std::size_t(1) << 25; // of a box: 128 MiB

} // namespace dipwright
