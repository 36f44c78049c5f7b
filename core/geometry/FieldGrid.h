// The sample positions of a body's distance field. The user sets the number of samples along each
// edge. A body with thinner parts gets as many samples as these parts need (docs/film-model.md,
// "The distance field's cells").
#pragma once

#include "geometry/SurfaceQuery.h"

namespace dipwright {

// How far a model lies from the origin, in longest edges of its bounding box, before its body
// coordinates differ from the model coordinates. At this distance, a float's rounding is 1e-4 of a
// cell if the box has 128 cells along an edge. Solvers find the surface to 1e-4 of a cell.
inline constexpr double farFromOrigin = 8;

// Returns the origin of a model's body coordinates, in model coordinates. Distance fields and
// solvers use body coordinates, because solvers compute with floats. Body coordinates are model
// coordinates unless the middle of the model's bounding box is farther from the origin than
// farFromOrigin; then their origin is this middle.
Eigen::Vector3d bodyOrigin(const TriangleMesh& model);
// Returns the model in its body coordinates.
TriangleMesh inBodyCoordinates(const TriangleMesh& model);

// Sample (i, j, k) lies at origin + spacing·(i, j, k), in mm.
struct FieldGrid {
    std::array<int, 3> size{};
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double spacing = 0;

    std::size_t sampleCount() const;
};

// Returns a cube with `resolution` (32 … 512) samples along each edge and at least two free cells
// around the body. Throws Error on another resolution or a body without extent.
FieldGrid cubeGrid(const TriangleMesh& body, int resolution);

// Returns a grid with cells of `spacing` mm that covers the body's bounding box and two free cells
// around it. Throws Error on a body without extent.
FieldGrid boxGrid(const TriangleMesh& body, double spacing);

// The thickness of the body's thinnest parts, mm: 1 % of the body's surface lies on parts that are
// thinner. A part has faces on both sides that are parallel to within 37°. Infinite if less than 1
// % of the surface lies on such parts.
struct ThinParts {
    double thickness = 0;
    double plate = 0; // the same, without parts that taper to a sharp edge
};
// Measures them. `query` must have been built from `body`. Uses all cores; deterministic.
ThinParts thinParts(const TriangleMesh& body, const SurfaceQuery& query);

// Whether a field on this grid resolves plates of this thickness.
bool isFineEnough(const FieldGrid& grid, double thinnest);

// The parts of a body that a field does not contain.
struct MissedParts {
    double area = 0;      // mm² of surface; 0: none
    double thickness = 0; // mm, of the thickest of them
};
// Returns the plates and pins that are thinner than one cell of `spacing` mm and stick out: their
// surface lies more than four cells from any thicker place, and more than two distances between the
// places that are looked at. A field may have no sample inside them, and then film passes through.
// Finds parts of at least 0.1 % of the surface. `query` must have been built from `body`. Uses all
// cores; deterministic.
MissedParts missedParts(const TriangleMesh& body, const SurfaceQuery& query, double spacing);

// Returns cubeGrid() if it is fine enough for parts of this thickness. Otherwise returns a box with
// finer cells, as fine as the parts need or mostFieldSamples allows.
FieldGrid fieldGrid(const TriangleMesh& body, int resolution, double thinnest);

// The largest number of samples in a box; they take 128 MiB.
inline constexpr std::size_t mostFieldSamples = std::size_t(1) << 25;

} // namespace dipwright
