// The loops over rows of the CPU's multigrid cycle, each compiled for every instruction set that
// Highway knows, as in RowKernels.h, and with the same bits on all of them.
//
// A grid's stiffness is a stencil a point: 2 × 2 numbers for itself and each of its eight
// neighbours. A row of points keeps it in 36 lines, one number of each point a line: first the
// three neighbours in the row below, then its own, then those above; of each xx, xz, zx, zz.
#pragma once

#include "production/cpu/RowKernels.h"

#include <cstddef>

namespace dipwright::cpu {

inline constexpr std::size_t stencilLines = 36;
inline constexpr std::size_t middleLine = 16;  // of the point with itself
inline constexpr std::size_t inverseLines = 3; // xx, xz, zz of a symmetric 2 × 2 block a point

// x and z of one row of points. The rows below and above it are `pitch` numbers away, and there are
// zeros round the grid.
template <typename Number>
struct RowOfVectors {
    Number *x = nullptr, *z = nullptr;
};

// Stiffness of the triangles in a row of cells: 16 lines each (EdgeStiffness.h: hh, hv, vh, vv) of
// first and second ones.
inline constexpr std::size_t triangleLines = 16;
struct RowOfTriangles {
    Lines<const float> first, second;
};

// Adds what a row of cells does to the rows of points below and above it. `parity` of the row, as
// in RowKernels.h.
void addToStencils(std::size_t cells, unsigned parity, const RowOfTriangles& triangles,
                   const Lines<float>& lower, const Lines<float>& upper);
// Clears what held points do and feel (`free` 0, of the rows below, here and above; each one number
// longer at both ends) and adds the drag of each free point.
struct RowsOfFree {
    const float *below, *here, *above;
};
void holdPoints(std::size_t columns, const RowsOfFree& free, float drag, const float* area,
                const Lines<float>& stencil);
// The inverse of the symmetric part of the points' own blocks; of a block that is nearly singular,
// of its trace; zero for one that is zero.
void invertMiddle(std::size_t columns, const Lines<const float>& stencil,
                  const Lines<float>& inverse);

// The coarse operator by the interpolation of grids of which the coarser has every second point
// (Galerkin), one axis after the other. Across rows: out += what one fine row gives to the stencil
// of a coarse row that lies `offset` (−1, 0, 1) rows below it.
void coarsenAcross(std::size_t columns, int offset, const Lines<const float>& fine,
                   const Lines<float>& coarse);
// Along a row, of which there are `fineColumns` points.
void coarsenAlong(std::size_t fineColumns, const Lines<const float>& fine,
                  const Lines<float>& coarse);

// One step of Chebyshev smoothing: direction ← keep·direction + gain·inverse·(right − K now), and
// result = now + direction. The first one from now = 0 needs no K.
struct ChebyshevRow {
    float keep, gain;
    Lines<const float> inverse;
    RowOfVectors<const float> right;
    RowOfVectors<float> direction, result;
};
void smoothFirst(std::size_t columns, const ChebyshevRow& row);
void smoothRow(std::size_t columns, std::size_t pitch, const ChebyshevRow& row,
               const Lines<const float>& stencil, const RowOfVectors<const float>& now);
// residual = right − K now
void residualRow(std::size_t columns, std::size_t pitch, const Lines<const float>& stencil,
                 const RowOfVectors<const float>& right, const RowOfVectors<const float>& now,
                 const RowOfVectors<float>& residual);

// The transpose of interpolateRow: of three fine rows to a coarse one. `sum`: room for a fine row
// and a number at each end.
void restrictRow(std::size_t fineColumns, std::size_t coarseColumns, std::size_t finePitch,
                 const float* fine, float* sum, float* coarse);
// Adds the coarse grid's vector, half from each of two coarse rows (the same one, where the fine
// row lies on it), to a fine row; times `factor` of each point if there is one.
void interpolateRow(std::size_t fineColumns, const float* lower, const float* upper,
                    const float* factor, float* fine);

} // namespace dipwright::cpu
