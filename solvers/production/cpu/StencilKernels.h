// The row loops of the CPU's multigrid cycle. Each is compiled for each instruction set that
// Highway supports, and all give the same bits, as in RowKernels.h.
//
// The stiffness of a grid is a stencil per point: a 2 × 2 block for the point itself and for each
// of its eight neighbours. A row of points stores its stencils in 36 lines, each with one number
// per point. First come the three neighbours in the row below, then the point's own row, then the
// row above. Each block has the order xx, xz, zx, zz.
#pragma once

#include "production/cpu/RowKernels.h"

#include <cstddef>
#include <cstdint>

namespace dipwright::cpu {

inline constexpr std::size_t stencilLines = 36;
inline constexpr std::size_t middleLine = 16;  // first line of the point's block with itself
inline constexpr std::size_t inverseLines = 3; // xx, xz, zz of a symmetric 2 × 2 block per point

// The lines of a row of stencils. Those before `middleLine` may lie elsewhere.
template <typename Number>
struct StencilLines {
    Lines<Number> early, others; // both are indexed from line 0
    Number* operator[](std::size_t line) const {
        return line < middleLine ? early[line] : others[line];
    }
};

// The x and z values of one row of points. The adjacent rows are `pitch` numbers away. Zeros
// surround the grid.
template <typename Number>
struct RowOfVectors {
    Number *x = nullptr, *z = nullptr;
};

// Number of lines with the stiffness of the first (or second) triangles in a row of cells
// (EdgeStiffness.h: hh, hv, vh, vv). Cell `i` has the number i + 1 in its line; before and after
// the cells, a line has a zero.
inline constexpr std::size_t triangleLines = 16;
struct RowOfTriangles {
    Lines<const float> first, second;
};
// `free` of the rows below, here and above, each with one extra number at both ends.
struct RowsOfFree {
    const float *below, *here, *above;
};
// Computes the stencils of a row of points from the stiffness of the rows of cells below and above
// it; beyond the grid's ends all lines are zero. `parity` is that of the row above, as in
// gradientRow() (RowKernels.h). The rows and columns of held points are zero (`free` is 0). A free
// point has a drag of `drag` times its entry in `area`.
void assembleStencils(std::size_t columns, unsigned parity, const RowOfTriangles& below,
                      const RowOfTriangles& above, const RowsOfFree& free, float drag,
                      const float* area, const StencilLines<float>& stencil);
// Inverts the symmetric part of each point's own block. A nearly singular block is replaced by the
// inverse of its trace, and a zero block by zero.
void invertMiddle(std::size_t columns, const Lines<const float>& stencil,
                  const Lines<float>& inverse);

// The stencils of three fine rows: the one that a coarse row lies on, and those before and after
// it. Beyond the grid's ends they are 0.
struct FineRows {
    StencilLines<const float> before, here, after;
};
// Computes the coarse operator by Galerkin interpolation, one axis after the other. The coarse grid
// has every second point. This function works across rows, for one coarse row.
void coarsenAcross(std::size_t columns, const FineRows& fine, const Lines<float>& coarse);
// Does the same along a row with `fineColumns` points.
void coarsenAlong(std::size_t fineColumns, const Lines<const float>& fine,
                  const Lines<float>& coarse);

// What is known about the stencils of `pointsPerKind` points.
enum class StencilKind : std::uint8_t {
    Any,
    // The stiffness between these points and all their neighbours is symmetric to the last bit. The
    // neighbours below and to the left then need not be read: their own stencils, which are in the
    // cache, have the transposed blocks.
    Symmetric,
    Held // all points are held, so all stencils and results are 0
};
inline constexpr std::size_t pointsPerKind = 16;
// The stencils of a row and of the row below it. Without `kinds`, all are StencilKind::Any, and
// `below` may be empty.
struct StencilRow {
    Lines<const float> here, below;
    const StencilKind* kinds = nullptr;

    DIPWRIGHT_IN_LOOP StencilKind kindAt(std::size_t point) const {
        return kinds == nullptr ? StencilKind::Any : kinds[point / pointsPerKind];
    }
};

// One step of Chebyshev smoothing: direction ← keep·direction + gain·inverse·(right − K·now), then
// result = now + direction. The first step starts from now = 0 and needs no K.
struct ChebyshevRow {
    float keep, gain;
    Lines<const float> inverse;
    RowOfVectors<const float> right;
    RowOfVectors<float> direction, result;
};
void smoothFirst(std::size_t columns, const ChebyshevRow& row);
void smoothRow(std::size_t columns, std::size_t pitch, const ChebyshevRow& row,
               const StencilRow& stencil, const RowOfVectors<const float>& now);
// Computes residual = right − K·now.
void residualRow(std::size_t columns, std::size_t pitch, const StencilRow& stencil,
                 const RowOfVectors<const float>& right, const RowOfVectors<const float>& now,
                 const RowOfVectors<float>& residual);

// Applies the transpose of interpolateRow, from three fine rows to a coarse row. `sum` is scratch
// memory: a fine row with one more number before it and two after it.
void restrictRow(std::size_t fineColumns, std::size_t coarseColumns, std::size_t finePitch,
                 const float* fine, float* sum, float* coarse);
// Adds the coarse grid's vector to a fine row, one half from each of two coarse rows. If the fine
// row lies on a coarse row, pass that row for both. `factor` multiplies each point's value; may be
// null.
void interpolateRow(std::size_t fineColumns, const float* lower, const float* upper,
                    const float* factor, float* fine);

} // namespace dipwright::cpu
