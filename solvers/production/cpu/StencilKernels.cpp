// As in RowKernels.cpp, loops with few operations use Highway's vectors. The compiler vectorises
// the others for each of Highway's instruction sets.

#include "production/cpu/StencilKernels.h"

#include "production/cpu/IndependentLoop.h"
#include "production/formulas/EdgeStiffness.h"
#include "production/formulas/GalerkinCycle.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "production/cpu/StencilKernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dipwright::cpu::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
using numerics::CellPoint;
using numerics::EdgeStiffness;
using numerics::Matrix2;

using Lanes = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Lanes>;
constexpr Lanes lanes;

HWY_INLINE Vector load(const float* from) {
    return hn::LoadU(lanes, from);
}

HWY_INLINE Matrix2<float> blockAt(const Lines<const float>& lines, std::size_t block,
                                  std::size_t i) {
    const std::size_t line = 4 * block;
    return {lines[line][i], lines[line + 1][i], lines[line + 2][i], lines[line + 3][i]};
}
HWY_INLINE EdgeStiffness<float> triangleAt(const Lines<const float>& lines, std::size_t i) {
    return {blockAt(lines, 0, i), blockAt(lines, 1, i), blockAt(lines, 2, i), blockAt(lines, 3, i)};
}
HWY_INLINE void putBlock(const StencilLines<float>& stencil, std::size_t line, std::size_t i,
                         const Matrix2<float>& block) {
    stencil[line][i] = block.a;
    stencil[line + 1][i] = block.b;
    stencil[line + 2][i] = block.c;
    stencil[line + 3][i] = block.d;
}

HWY_NOINLINE void assemblePoints(std::size_t begin, std::size_t end, unsigned parity,
                                 RowOfTriangles below, RowOfTriangles above, RowsOfFree free,
                                 float drag, const float* area, StencilLines<float> stencil) {
    using numerics::cellRow;
    using numerics::detail::plus;
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = begin; i < end; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        // Each of the four cells around the point adds its part, in this order.
        const auto belowRight = cellRow<CellPoint::UpperLeft>(
            triangleAt(below.first, i + 1), triangleAt(below.second, i + 1), !even);
        const auto belowLeft = cellRow<CellPoint::UpperRight>(triangleAt(below.first, i),
                                                              triangleAt(below.second, i), even);
        const auto aboveRight = cellRow<CellPoint::LowerLeft>(
            triangleAt(above.first, i + 1), triangleAt(above.second, i + 1), even);
        const auto aboveLeft = cellRow<CellPoint::LowerRight>(triangleAt(above.first, i),
                                                              triangleAt(above.second, i), !even);
        const Matrix2<float> zero{};
        const float isFree = free.here[i + 1];
        const auto put = [&](std::size_t line, float isThereFree, const Matrix2<float>& block) {
            putBlock(stencil, line, i, scaled(plus(zero, block), isFree * isThereFree));
        };
        put(0, free.below[i], belowLeft.toLowerLeft);
        put(4, free.below[i + 1], plus(belowRight.toLowerLeft, belowLeft.toLowerRight));
        put(8, free.below[i + 2], belowRight.toLowerRight);
        put(12, free.here[i], plus(belowLeft.toUpperLeft, aboveLeft.toLowerLeft));
        Matrix2<float> own =
            scaled(plus(zero, plus(plus(plus(belowRight.toUpperLeft, belowLeft.toUpperRight),
                                        aboveRight.toLowerLeft),
                                   aboveLeft.toLowerRight)),
                   isFree * isFree);
        const float resistance = drag * area[i] * isFree;
        own.a += resistance;
        own.d += resistance;
        putBlock(stencil, middleLine, i, own);
        put(20, free.here[i + 2], plus(belowRight.toUpperRight, aboveRight.toLowerRight));
        put(24, free.above[i], aboveLeft.toUpperLeft);
        put(28, free.above[i + 1], plus(aboveRight.toUpperLeft, aboveLeft.toUpperRight));
        put(32, free.above[i + 2], aboveRight.toUpperRight);
    }
}

void assembleStencils(std::size_t columns, unsigned parity, const RowOfTriangles& below,
                      const RowOfTriangles& above, const RowsOfFree& free, float drag,
                      const float* area, const StencilLines<float>& stencil) {
    inWholeVectors(columns, [&](std::size_t begin, std::size_t end) {
        assemblePoints(begin, end, parity, below, above, free, drag, area, stencil);
    });
}

void invertMiddle(std::size_t columns, const Lines<const float>& stencil,
                  const Lines<float>& inverse) {
    float *xx = inverse[0], *xz = inverse[1], *zz = inverse[2];
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < columns; ++i) {
        const Matrix2<float> own = blockAt(stencil, middleLine / 4, i);
        const float mixed = (own.b + own.c) / 2, trace = own.a + own.d;
        const float determinant = own.a * own.d - mixed * mixed;
        const bool isStiff = trace > 0;
        const bool isRegular =
            isStiff && determinant > numerics::galerkin::leastDeterminant * trace * trace;
        // One division for all cases, because compilers do not vectorise a conditional one.
        const float quotient = 1 / (isRegular ? determinant : isStiff ? trace : 1);
        const float scale = isRegular ? quotient : 0, common = isRegular || !isStiff ? 0 : quotient;
        xx[i] = own.d * scale + common;
        xz[i] = -mixed * scale;
        zz[i] = own.a * scale + common;
    }
}

// Adds the contributions of fine points to coarse points. A fine point on a coarse point
// contributes fully to it. A fine point between two coarse points contributes one half to each.
// With a fine operator a at a coarse point (0) and at the fine points before (−) and after (+) it,
// the coarse operator is
//     to the point before  = ½ a0[−] + ½ (½ a−[0] + a−[−])
//     to the point itself  = a0[0] + ½ a0[−] + ½ a0[+] + ½ (½ a−[0] + a−[+])
//                            + ½ (½ a+[0] + a+[−])
//     to the point after   = ½ a0[+] + ½ (½ a+[0] + a+[+]).
void coarsenAcross(std::size_t columns, const FineRows& fine, const Lines<float>& coarse) {
    constexpr std::size_t linesOfRow = stencilLines / 3;
    for (std::size_t line = 0; line < linesOfRow; ++line) {
        const std::size_t ownLine = line + linesOfRow, aboveLine = line + 2 * linesOfRow;
        const float *beforeBelow = fine.before[line], *beforeOwn = fine.before[ownLine],
                    *beforeAbove = fine.before[aboveLine];
        const float *below = fine.here[line], *own = fine.here[ownLine],
                    *above = fine.here[aboveLine];
        const float *afterBelow = fine.after[line], *afterOwn = fine.after[ownLine],
                    *afterAbove = fine.after[aboveLine];
        float *toBelow = coarse[line], *toOwn = coarse[ownLine], *toAbove = coarse[aboveLine];
        DIPWRIGHT_INDEPENDENT_LOOP
        for (std::size_t i = 0; i < columns; ++i) {
            toBelow[i] = 0.5f * (0.5f * beforeOwn[i] + beforeBelow[i]) + 0.5f * below[i];
            toOwn[i] = (0.5f * (0.5f * beforeOwn[i] + beforeAbove[i]) +
                        (own[i] + 0.5f * (below[i] + above[i]))) +
                       0.5f * (0.5f * afterOwn[i] + afterBelow[i]);
            toAbove[i] = 0.5f * above[i] + 0.5f * (0.5f * afterOwn[i] + afterAbove[i]);
        }
    }
}

void coarsenAlong(std::size_t fineColumns, const Lines<const float>& fine,
                  const Lines<float>& coarse) {
    const std::size_t whole =
        (fineColumns - 1) / 2; // coarse points 1 … whole − 1 have both neighbours
    for (std::size_t ofRow = 0; ofRow < stencilLines; ofRow += stencilLines / 3) {
        for (std::size_t line = ofRow; line < ofRow + 4; ++line) {
            const float* before = fine[line];
            const float* own = fine[line + 4];
            const float* after = fine[line + 8];
            float* toBefore = coarse[line];
            float* toOwn = coarse[line + 4];
            float* toAfter = coarse[line + 8];
            const auto give = [&](std::size_t c, bool hasBefore, bool hasHere, bool hasAfter) {
                const std::size_t i = 2 * c;
                float outBefore = 0, outOwn = 0, outAfter = 0;
                if (hasBefore) {
                    outBefore += 0.5f * (0.5f * own[i - 1] + before[i - 1]);
                    outOwn += 0.5f * (0.5f * own[i - 1] + after[i - 1]);
                }
                if (hasHere) {
                    outBefore += 0.5f * before[i];
                    outOwn += own[i] + 0.5f * (before[i] + after[i]);
                    outAfter += 0.5f * after[i];
                }
                if (hasAfter) {
                    outOwn += 0.5f * (0.5f * own[i + 1] + before[i + 1]);
                    outAfter += 0.5f * (0.5f * own[i + 1] + after[i + 1]);
                }
                toBefore[c] = outBefore;
                toOwn[c] = outOwn;
                toAfter[c] = outAfter;
            };
            give(0, false, true, fineColumns > 1);
            DIPWRIGHT_INDEPENDENT_LOOP
            for (std::size_t c = 1; c < whole; ++c) {
                give(c, true, true, true);
            }
            for (std::size_t c = whole > 1 ? whole : 1; c <= fineColumns / 2; ++c) {
                give(c, true, 2 * c < fineColumns, 2 * c + 1 < fineColumns);
            }
        }
    }
}

struct Pair {
    Vector x, z;
};

// Subtracts the part of one neighbour.
HWY_INLINE void subtract(Pair& left, const Vector& xx, const Vector& xz, const Vector& zx,
                         const Vector& zz, const float* nowX, const float* nowZ) {
    const Vector x = load(nowX), z = load(nowZ);
    left.x = hn::Sub(left.x, hn::Add(hn::Mul(xx, x), hn::Mul(xz, z)));
    left.z = hn::Sub(left.z, hn::Add(hn::Mul(zx, x), hn::Mul(zz, z)));
}

// Returns right − K·now at the points i, i + 1, …. Subtracts the nine neighbours' parts row by row.
HWY_INLINE Pair residualAt(const StencilRow& stencil, std::size_t pitch,
                           const RowOfVectors<const float>& right,
                           const RowOfVectors<const float>& now, std::size_t i) {
    Pair left{load(right.x + i), load(right.z + i)};
    constexpr std::size_t own = middleLine / 4;
    const auto to = [&](std::size_t neighbour) {
        return (std::ptrdiff_t(neighbour / 3) - 1) * std::ptrdiff_t(pitch) +
               std::ptrdiff_t(neighbour % 3) - 1 + std::ptrdiff_t(i);
    };
    const auto subtractOwn = [&](std::size_t neighbour) HWY_ATTR {
        const std::size_t line = 4 * neighbour;
        const Lines<const float>& here = stencil.here;
        subtract(left, load(here[line] + i), load(here[line + 1] + i), load(here[line + 2] + i),
                 load(here[line + 3] + i), now.x + to(neighbour), now.z + to(neighbour));
    };
    if (stencil.kindAt(i) == StencilKind::Any) {
        for (std::size_t neighbour = 0; neighbour < 9; ++neighbour) {
            subtractOwn(neighbour);
        }
        return left;
    }
    // The block of a neighbour with this point, transposed.
    for (std::size_t neighbour = 0; neighbour < own; ++neighbour) {
        const Lines<const float>& there = neighbour < 3 ? stencil.below : stencil.here;
        const std::size_t line = 4 * (8 - neighbour);
        const std::size_t at = i + neighbour % 3 - 1;
        subtract(left, load(there[line] + at), load(there[line + 2] + at),
                 load(there[line + 1] + at), load(there[line + 3] + at), now.x + to(neighbour),
                 now.z + to(neighbour));
    }
    for (std::size_t neighbour = own; neighbour < 9; ++neighbour) {
        subtractOwn(neighbour);
    }
    return left;
}

// Rows have space for whole vectors past their end. Stencils and inverses are 0 there.
HWY_INLINE void takeStep(const ChebyshevRow& row, std::size_t i, const Pair& residual,
                         const Pair& now) {
    const Vector gain = hn::Set(lanes, row.gain);
    const Vector xx = load(row.inverse[0] + i), xz = load(row.inverse[1] + i),
                 zz = load(row.inverse[2] + i);
    const Vector x = hn::Add(hn::Mul(xx, residual.x), hn::Mul(xz, residual.z));
    const Vector z = hn::Add(hn::Mul(xz, residual.x), hn::Mul(zz, residual.z));
    Vector dx = hn::Mul(gain, x), dz = hn::Mul(gain, z);
    if (row.keep != 0) { // otherwise the old direction may be anything
        const Vector keep = hn::Set(lanes, row.keep);
        dx = hn::Add(hn::Mul(keep, load(row.direction.x + i)), dx);
        dz = hn::Add(hn::Mul(keep, load(row.direction.z + i)), dz);
    }
    hn::StoreU(dx, lanes, row.direction.x + i);
    hn::StoreU(dz, lanes, row.direction.z + i);
    hn::StoreU(hn::Add(now.x, dx), lanes, row.result.x + i);
    hn::StoreU(hn::Add(now.z, dz), lanes, row.result.z + i);
}

HWY_INLINE void clear(const RowOfVectors<float>& row, std::size_t i) {
    hn::StoreU(hn::Zero(lanes), lanes, row.x + i);
    hn::StoreU(hn::Zero(lanes), lanes, row.z + i);
}

void smoothFirst(std::size_t columns, const ChebyshevRow& row) {
    const Pair nothing{hn::Zero(lanes), hn::Zero(lanes)};
    for (std::size_t i = 0; i < columns; i += hn::Lanes(lanes)) {
        takeStep(row, i, {load(row.right.x + i), load(row.right.z + i)}, nothing);
    }
}

void smoothRow(std::size_t columns, std::size_t pitch, const ChebyshevRow& row,
               const StencilRow& stencil, const RowOfVectors<const float>& now) {
    for (std::size_t i = 0; i < columns; i += hn::Lanes(lanes)) {
        if (stencil.kindAt(i) == StencilKind::Held) {
            clear(row.direction, i);
            clear(row.result, i);
            continue;
        }
        takeStep(row, i, residualAt(stencil, pitch, row.right, now, i),
                 {load(now.x + i), load(now.z + i)});
    }
}

void residualRow(std::size_t columns, std::size_t pitch, const StencilRow& stencil,
                 const RowOfVectors<const float>& right, const RowOfVectors<const float>& now,
                 const RowOfVectors<float>& residual) {
    for (std::size_t i = 0; i < columns; i += hn::Lanes(lanes)) {
        if (stencil.kindAt(i) == StencilKind::Held) {
            clear(residual, i);
            continue;
        }
        const Pair left = residualAt(stencil, pitch, right, now, i);
        hn::StoreU(left.x, lanes, residual.x + i);
        hn::StoreU(left.z, lanes, residual.z + i);
    }
}

void restrictRow(std::size_t fineColumns, std::size_t coarseColumns, std::size_t finePitch,
                 const float* fine, float* sum, float* coarse) {
    const float *below = fine - finePitch, *above = fine + finePitch;
    sum[0] = 0;
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < fineColumns; ++i) {
        sum[i + 1] = fine[i] + 0.5f * (below[i] + above[i]);
    }
    sum[fineColumns + 1] = sum[fineColumns + 2] = 0;
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t c = 0; c < coarseColumns; ++c) {
        coarse[c] = sum[2 * c + 1] + 0.5f * (sum[2 * c] + sum[2 * c + 2]);
    }
}

void interpolateRow(std::size_t fineColumns, const float* lower, const float* upper,
                    const float* factor, float* fine) {
    const auto weight = [&](std::size_t i) { return factor != nullptr ? factor[i] : 1.f; };
    const std::size_t pairs = fineColumns / 2;
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t c = 0; c < pairs; ++c) {
        const float here = lower[c] + upper[c], next = lower[c + 1] + upper[c + 1];
        fine[2 * c] += weight(2 * c) * (0.5f * here);
        fine[2 * c + 1] += weight(2 * c + 1) * (0.25f * (here + next));
    }
    if (fineColumns % 2 != 0) {
        fine[2 * pairs] += weight(2 * pairs) * (0.5f * (lower[pairs] + upper[pairs]));
    }
}

} // namespace

} // namespace dipwright::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dipwright::cpu {

namespace {

HWY_EXPORT(assembleStencils);
HWY_EXPORT(invertMiddle);
HWY_EXPORT(coarsenAcross);
HWY_EXPORT(coarsenAlong);
HWY_EXPORT(smoothFirst);
HWY_EXPORT(smoothRow);
HWY_EXPORT(residualRow);
HWY_EXPORT(restrictRow);
HWY_EXPORT(interpolateRow);

} // namespace

void assembleStencils(std::size_t columns, unsigned parity, const RowOfTriangles& below,
                      const RowOfTriangles& above, const RowsOfFree& free, float drag,
                      const float* area, const StencilLines<float>& stencil) {
    HWY_DYNAMIC_DISPATCH(assembleStencils)
    (columns, parity, below, above, free, drag, area, stencil);
}
void invertMiddle(std::size_t columns, const Lines<const float>& stencil,
                  const Lines<float>& inverse) {
    HWY_DYNAMIC_DISPATCH(invertMiddle)(columns, stencil, inverse);
}
void coarsenAcross(std::size_t columns, const FineRows& fine, const Lines<float>& coarse) {
    HWY_DYNAMIC_DISPATCH(coarsenAcross)(columns, fine, coarse);
}
void coarsenAlong(std::size_t fineColumns, const Lines<const float>& fine,
                  const Lines<float>& coarse) {
    HWY_DYNAMIC_DISPATCH(coarsenAlong)(fineColumns, fine, coarse);
}
void smoothFirst(std::size_t columns, const ChebyshevRow& row) {
    HWY_DYNAMIC_DISPATCH(smoothFirst)(columns, row);
}
void smoothRow(std::size_t columns, std::size_t pitch, const ChebyshevRow& row,
               const StencilRow& stencil, const RowOfVectors<const float>& now) {
    HWY_DYNAMIC_DISPATCH(smoothRow)(columns, pitch, row, stencil, now);
}
void residualRow(std::size_t columns, std::size_t pitch, const StencilRow& stencil,
                 const RowOfVectors<const float>& right, const RowOfVectors<const float>& now,
                 const RowOfVectors<float>& residual) {
    HWY_DYNAMIC_DISPATCH(residualRow)(columns, pitch, stencil, right, now, residual);
}
void restrictRow(std::size_t fineColumns, std::size_t coarseColumns, std::size_t finePitch,
                 const float* fine, float* sum, float* coarse) {
    HWY_DYNAMIC_DISPATCH(restrictRow)(fineColumns, coarseColumns, finePitch, fine, sum, coarse);
}
void interpolateRow(std::size_t fineColumns, const float* lower, const float* upper,
                    const float* factor, float* fine) {
    HWY_DYNAMIC_DISPATCH(interpolateRow)(fineColumns, lower, upper, factor, fine);
}

} // namespace dipwright::cpu
#endif
