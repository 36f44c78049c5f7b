// Defines the film's triangles: their corners in the grid, their edges, and the forces on these
// edges.
//
// Each triangle has one horizontal and one vertical grid edge. Its forces act on these two edges
// (FilmSolver.h, FilmGrid, defines how cells are divided).
#pragma once

#include "production/formulas/PlaneStress.h"

#include <cstddef>
#include <cstdint>

namespace dipwright::numerics {

// The film points of a triangle: the two ends of its horizontal edge, and the third corner. The
// third corner shares the vertical edge with one of the two ends.
struct TriangleCorners {
    std::uint32_t points[3]; // left, right, third
    bool thirdOnRight;
    bool thirdAbove; // the third corner lies in the next row

    // Returns the index of the corner that both edges share.
    DIPWRIGHT_HOST_DEVICE int shared() const { return thirdOnRight ? 1 : 0; }
};

// Returns the corners of a cell's first triangle (on the lower horizontal edge) or second triangle
// (on the upper edge).
DIPWRIGHT_HOST_DEVICE inline TriangleCorners triangleCorners(int columns, int column, int row,
                                                             bool second) {
    const bool even = (column + row) % 2 == 0;
    const bool onRight = even != second;
    const std::uint32_t lower = std::uint32_t(row) * std::uint32_t(columns) + std::uint32_t(column);
    const std::uint32_t upper = lower + std::uint32_t(columns);
    const std::uint32_t base = second ? upper : lower;
    const std::uint32_t third = (second ? lower : upper) + (onRight ? 1 : 0);
    return {{base, base + 1, third}, onRight, !second};
}

// Returns the corners by the triangle's number: two triangles per cell, cell by cell.
DIPWRIGHT_HOST_DEVICE inline TriangleCorners triangleCorners(int columns, std::size_t number) {
    const int cell = int(number / 2), cells = columns - 1;
    return triangleCorners(columns, cell % cells, cell / cells, number % 2 != 0);
}

// The x and z components of a triangle's horizontal and vertical edge, from lower to higher grid
// index. Also used for the forces on these edges, as a gradient: + at the higher end, − at the
// lower end.
template <typename Real>
struct EdgePair {
    Real hx{}, hz{}, vx{}, vz{};
};

// Returns the deformation gradient.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> gradientOf(const EdgePair<Real>& edges,
                                                      const Matrix2<Real>& inverseShape) {
    return Matrix2<Real>{edges.hx, edges.vx, edges.hz, edges.vz} * inverseShape;
}

// Converts stress to forces on the two edges: area · P · inverseShapeᵀ.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline EdgePair<Real>
edgeForces(const Matrix2<Real>& P, const Matrix2<Real>& inverseShape, Real area) {
    return {area * (P.a * inverseShape.a + P.b * inverseShape.b),
            area * (P.c * inverseShape.a + P.d * inverseShape.b),
            area * (P.a * inverseShape.c + P.b * inverseShape.d),
            area * (P.c * inverseShape.c + P.d * inverseShape.d)};
}

} // namespace dipwright::numerics
