// There are two kinds of loops. Loops with few operations use Highway's vectors. Loops with the
// film's elastic law, which all devices share (PlaneStress.h), are plain C++. GCC and Clang
// vectorise these for each of Highway's instruction sets; MSVC uses the instruction set of the
// whole program.

#include "production/cpu/RowKernels.h"

#include "production/cpu/IndependentLoop.h"
#include "production/formulas/EdgeStiffness.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "production/cpu/RowKernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dipwright::cpu::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Lanes>;
constexpr Lanes lanes;

// The terms of a sum, in double precision, and as integers.
using Doubles = hn::CappedTag<double, 8>;
using Integers = hn::RebindToSigned<Doubles>;
using Floats = hn::Rebind<float, Doubles>; // as many numbers as Doubles
constexpr Doubles doubles;
constexpr Integers integers;
constexpr Floats floats;

HWY_INLINE Vector load(const float* from) {
    return hn::LoadU(lanes, from);
}
HWY_INLINE std::size_t laneCount() {
    return hn::Lanes(lanes);
}

// Sets out[i] = whole(i) in whole vectors from `first` on, and out[i] = one(i) for the remaining
// numbers up to `last`. Both must use the same arithmetic.
template <typename Whole, typename One>
HWY_INLINE void forRow(std::size_t first, std::size_t last, float* out, const Whole& whole,
                       const One& one) {
    std::size_t i = first;
    for (; i + laneCount() <= last; i += laneCount()) {
        hn::StoreU(whole(i), lanes, out + i);
    }
    for (; i < last; ++i) {
        out[i] = one(i);
    }
}

using Terms = hn::Vec<Doubles>;
using Multiples = hn::Vec<Integers>;

HWY_INLINE Terms asTerms(const hn::Vec<Floats>& values) {
    return hn::PromoteTo(doubles, values);
}
HWY_INLINE hn::Vec<Floats> loadFloats(const float* from) {
    return hn::LoadU(floats, from);
}
HWY_INLINE Multiples bitsOf(const Terms& terms) {
    return hn::BitCast(integers, terms);
}
HWY_INLINE std::int64_t sumOf(const Multiples& multiples) {
    return hn::GetLane(hn::SumOfLanes(integers, multiples));
}

std::int64_t rowProducts(const RowOfPairs& a, const RowOfPairs& b, float factor,
                         std::size_t count) {
    using numerics::ProductSum;
    const Terms scale = hn::Set(doubles, double(factor));
    const Terms shift = hn::Set(doubles, ProductSum::shift);
    const Terms limit = hn::Set(doubles, ProductSum::limit);
    const Multiples none = bitsOf(shift);
    Multiples sums = hn::Zero(integers);
    std::size_t i = 0;
    for (; i + hn::Lanes(doubles) <= count; i += hn::Lanes(doubles)) {
        const auto product = hn::Add(hn::Mul(loadFloats(a.x + i), loadFloats(b.x + i)),
                                     hn::Mul(loadFloats(a.z + i), loadFloats(b.z + i)));
        const Terms given = hn::Mul(asTerms(product), scale);
        const Terms term = hn::IfThenElseZero(hn::Lt(hn::Abs(given), limit), given);
        sums = hn::Add(sums, hn::Sub(bitsOf(hn::Add(term, shift)), none));
    }
    std::int64_t sum = sumOf(sums);
    for (; i < count; ++i) {
        const float product = a.x[i] * b.x[i] + a.z[i] * b.z[i];
        sum += ProductSum::multiple(double(product) * double(factor));
    }
    return sum;
}

// Returns the sum of square(i) in whole vectors, and of one(i) for the remaining numbers. Both must
// use the same arithmetic.
template <typename Square, typename One>
HWY_INLINE numerics::SquareSum sumOfSquares(std::size_t count, const Square& square,
                                            const One& one) {
    using numerics::SquareSum;
    const Terms limit = hn::Set(doubles, SquareSum::limit);
    const Terms coarseShift = hn::Set(doubles, SquareSum::coarseShift);
    const Terms shift = hn::Set(doubles, SquareSum::shift);
    const Multiples none = bitsOf(shift), noCoarse = bitsOf(coarseShift);
    Multiples coarse = hn::Zero(integers), rest = hn::Zero(integers);
    std::size_t i = 0;
    for (; i + hn::Lanes(doubles) <= count; i += hn::Lanes(doubles)) { // as SquareSum::add()
        const Terms given = asTerms(square(i));
        const Terms term = hn::IfThenElse(hn::Lt(given, limit), given, limit);
        const Terms shifted = hn::Add(term, coarseShift);
        const Terms left = hn::Sub(term, hn::Sub(shifted, coarseShift));
        coarse = hn::Add(coarse, hn::Sub(bitsOf(shifted), noCoarse));
        rest = hn::Add(rest, hn::Sub(bitsOf(hn::Add(left, shift)), none));
    }
    SquareSum sum{sumOf(coarse), sumOf(rest)};
    for (; i < count; ++i) {
        sum.add(double(one(i)));
    }
    return sum;
}

numerics::SquareSum rowSquares(const RowOfPairs& a, std::size_t count) {
    return sumOfSquares(
        count,
        [&](std::size_t i) HWY_ATTR {
            const auto x = loadFloats(a.x + i), z = loadFloats(a.z + i);
            return hn::Add(hn::Mul(x, x), hn::Mul(z, z));
        },
        [&](std::size_t i) { return a.x[i] * a.x[i] + a.z[i] * a.z[i]; });
}

numerics::SquareSum rowWeightedSquares(const float* weight, const RowOfPairs& a,
                                       std::size_t count) {
    return sumOfSquares(
        count,
        [&](std::size_t i) HWY_ATTR {
            const auto x = loadFloats(a.x + i), z = loadFloats(a.z + i);
            return hn::Mul(loadFloats(weight + i), hn::Add(hn::Mul(x, x), hn::Mul(z, z)));
        },
        [&](std::size_t i) { return weight[i] * (a.x[i] * a.x[i] + a.z[i] * a.z[i]); });
}

float rowLargest(const float* a, std::size_t count) {
    Vector most = hn::Zero(lanes);
    std::size_t i = 0;
    for (; i + laneCount() <= count; i += laneCount()) {
        const Vector size = hn::Abs(load(a + i));
        most = hn::IfThenElse(hn::Gt(size, most), size, most);
    }
    float largest = hn::GetLane(hn::MaxOfLanes(lanes, most));
    for (; i < count; ++i) {
        const float size = a[i] < 0 ? -a[i] : a[i];
        largest = size > largest ? size : largest;
    }
    return largest;
}

void addScaled(std::size_t count, float factor, const float* a, float* out) {
    const Vector scale = hn::Set(lanes, factor);
    forRow(
        0, count, out,
        [&](std::size_t i) HWY_ATTR { return hn::Add(load(out + i), hn::Mul(scale, load(a + i))); },
        [&](std::size_t i) { return out[i] + factor * a[i]; });
}

void scaledRow(std::size_t count, float factor, const float* a, float* out) {
    const Vector scale = hn::Set(lanes, factor);
    forRow(
        0, count, out, [&](std::size_t i) HWY_ATTR { return hn::Mul(scale, load(a + i)); },
        [&](std::size_t i) { return factor * a[i]; });
}

void addWeighted(std::size_t count, float factor, const float* weight, const float* a, float* out) {
    const Vector scale = hn::Set(lanes, factor);
    forRow(
        0, count, out,
        [&](std::size_t i) HWY_ATTR {
            return hn::Add(load(out + i), hn::Mul(hn::Mul(scale, load(weight + i)), load(a + i)));
        },
        [&](std::size_t i) { return out[i] + factor * weight[i] * a[i]; });
}

void addDifference(std::size_t count, float factor, const float* weight, const float* a,
                   const float* b, float* out) {
    const Vector scale = hn::Set(lanes, factor);
    forRow(
        0, count, out,
        [&](std::size_t i) HWY_ATTR {
            return hn::Add(load(out + i), hn::Mul(hn::Mul(scale, load(weight + i)),
                                                  hn::Sub(load(a + i), load(b + i))));
        },
        [&](std::size_t i) { return out[i] + factor * weight[i] * (a[i] - b[i]); });
}

void multiplyBy(std::size_t count, const float* a, float* out) {
    forRow(
        0, count, out, [&](std::size_t i) HWY_ATTR { return hn::Mul(load(out + i), load(a + i)); },
        [&](std::size_t i) { return out[i] * a[i]; });
}

// Writes the forces of both triangles of a cell to the cell's edges.
HWY_INLINE void putForces(const RowOfForces& out, std::size_t i, bool even,
                          const numerics::EdgePair<float>& first,
                          const numerics::EdgePair<float>& second) {
    out.firstX[i] = first.hx;
    out.firstZ[i] = first.hz;
    out.secondX[i] = second.hx;
    out.secondZ[i] = second.hz;
    out.leftX[i] = even ? second.vx : first.vx;
    out.leftZ[i] = even ? second.vz : first.vz;
    out.rightX[i] = even ? first.vx : second.vx;
    out.rightZ[i] = even ? first.vz : second.vz;
}

HWY_INLINE float areaAt(const RowOfShapes& shapes, std::size_t i) {
    return shapes.sizes.edgesX[i] * shapes.sizes.edgeZ / 2;
}

template <bool crept>
HWY_INLINE numerics::Matrix2<float> shapeAt(const RowOfShapes& shapes, bool second, std::size_t i) {
    if constexpr (crept) {
        const RowOfShapes::Pointers& shape = shapes.shapes[second];
        return {shape.a[i], shape.b[i], shape.c[i], shape.d[i]};
    } else {
        return {shapes.sizes.inversesX[i], 0, 0, shapes.sizes.inverseZ};
    }
}

// The parameters are passed by value. So the compiler knows that the loop does not overwrite its
// own pointers.
template <bool crept>
HWY_NOINLINE void gradientCells(std::size_t begin, std::size_t end, unsigned parity, RowOfPoints p,
                                RowOfShapes shapes, float gatheredResistance,
                                RowOfStates<float*> states, RowOfForces out) {
    const auto [first, second] = states.states;
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = begin; i < end; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        numerics::StressState<float> state0, state1;
        const numerics::Matrix2<float> shape0 = shapeAt<crept>(shapes, false, i);
        const numerics::Matrix2<float> shape1 = shapeAt<crept>(shapes, true, i);
        const float restX = shapes.sizes.edgesX[i], restZ = shapes.sizes.edgeZ;
        const float area = areaAt(shapes, i);
        const numerics::EdgePair<float> force0 =
            edgeForces(stress(gradientOf(cellEdges(p, i, false, even, restX, restZ), shape0),
                              gatheredResistance, state0),
                       shape0, area);
        const numerics::EdgePair<float> force1 =
            edgeForces(stress(gradientOf(cellEdges(p, i, true, !even, restX, restZ), shape1),
                              gatheredResistance, state1),
                       shape1, area);
        first.cosine[i] = state0.cosine;
        first.sine[i] = state0.sine;
        first.turn[i] = state0.turn;
        first.resists[i] = state0.resists;
        second.cosine[i] = state1.cosine;
        second.sine[i] = state1.sine;
        second.turn[i] = state1.turn;
        second.resists[i] = state1.resists;
        putForces(out, i, even, force0, force1);
    }
}

HWY_INLINE numerics::StressState<float> stateAt(const RowOfStates<const float*>::Pointers& states,
                                                std::size_t i) {
    return {states.cosine[i], states.sine[i], states.turn[i], states.resists[i]};
}

template <bool crept>
HWY_NOINLINE void hessianCells(std::size_t begin, std::size_t end, unsigned parity, RowOfPoints p,
                               RowOfShapes shapes, RowOfStates<const float*> states,
                               numerics::Tangent tangent, RowOfForces out) {
    const auto [first, second] = states.states;
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = begin; i < end; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        const numerics::Matrix2<float> shape0 = shapeAt<crept>(shapes, false, i);
        const numerics::Matrix2<float> shape1 = shapeAt<crept>(shapes, true, i);
        const numerics::StressState<float> state0 = stateAt(first, i), state1 = stateAt(second, i);
        const numerics::EdgePair<float> force0 =
            edgeForces(stressDerivative(gradientOf(cellEdges(p, i, false, even, 0, 0), shape0),
                                        state0, tangent),
                       shape0, areaAt(shapes, i));
        const numerics::EdgePair<float> force1 =
            edgeForces(stressDerivative(gradientOf(cellEdges(p, i, true, !even, 0, 0), shape1),
                                        state1, tangent),
                       shape1, areaAt(shapes, i));
        putForces(out, i, even, force0, force1);
    }
}

void gradientRow(std::size_t cells, unsigned parity, const RowOfPoints& points,
                 const RowOfShapes& shapes, float gatheredResistance,
                 const RowOfStates<float*>& states, const RowOfForces& forces) {
    inWholeVectors(cells, [&](std::size_t begin, std::size_t end) {
        const auto work = shapes.isCrept ? gradientCells<true> : gradientCells<false>;
        work(begin, end, parity, points, shapes, gatheredResistance, states, forces);
    });
}

void hessianRow(std::size_t cells, unsigned parity, const RowOfPoints& direction,
                const RowOfShapes& shapes, const RowOfStates<const float*>& states,
                numerics::Tangent tangent, const RowOfForces& forces) {
    inWholeVectors(cells, [&](std::size_t begin, std::size_t end) {
        const auto work = shapes.isCrept ? hessianCells<true> : hessianCells<false>;
        work(begin, end, parity, direction, shapes, states, tangent, forces);
    });
}

HWY_INLINE void putBlock(const Lines<float>& lines, std::size_t block, std::size_t i,
                         const numerics::Matrix2<float>& value) {
    lines[4 * block][i] = value.a;
    lines[4 * block + 1][i] = value.b;
    lines[4 * block + 2][i] = value.c;
    lines[4 * block + 3][i] = value.d;
}

template <bool crept>
HWY_NOINLINE void stiffnessCells(std::size_t begin, std::size_t end, RowOfShapes shapes,
                                 bool second, RowOfStates<const float*>::Pointers states,
                                 Lines<float> out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = begin; i < end; ++i) {
        const numerics::EdgeStiffness<float> stiffness =
            edgeStiffness(shapeAt<crept>(shapes, second, i), stateAt(states, i), areaAt(shapes, i));
        putBlock(out, 0, i, stiffness.hh);
        putBlock(out, 1, i, stiffness.hv);
        putBlock(out, 2, i, stiffness.vh);
        putBlock(out, 3, i, stiffness.vv);
    }
}

void stiffnessRow(std::size_t cells, const RowOfShapes& shapes,
                  const RowOfStates<const float*>& states, const Lines<float>& first,
                  const Lines<float>& second) {
    inWholeVectors(cells, [&](std::size_t begin, std::size_t end) {
        const auto work = shapes.isCrept ? stiffnessCells<true> : stiffnessCells<false>;
        work(begin, end, shapes, false, states.states[0], first);
        work(begin, end, shapes, true, states.states[1], second);
    });
}

template <bool crept, bool second>
HWY_NOINLINE void relaxCells(std::size_t begin, std::size_t end, unsigned parity, RowOfPoints p,
                             RowOfShapes shapes, float keep, Lines<float> relaxed) {
    float *a = relaxed[0], *b = relaxed[1], *c = relaxed[2], *d = relaxed[3];
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = begin; i < end; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        const numerics::Matrix2<float> shape = shapeAt<crept>(shapes, second, i);
        const numerics::EdgePair<float> edges =
            cellEdges(p, i, second, even != second, shapes.sizes.edgesX[i], shapes.sizes.edgeZ);
        const numerics::Matrix2<float> result =
            relaxedInverseShape(shape, gradientOf(edges, shape), keep);
        a[i] = result.a;
        b[i] = result.b;
        c[i] = result.c;
        d[i] = result.d;
    }
}

void relaxRow(std::size_t cells, unsigned parity, bool second, const RowOfPoints& points,
              const RowOfShapes& shapes, float keep, const Lines<float>& relaxed) {
    inWholeVectors(cells, [&](std::size_t begin, std::size_t end) {
        const auto work = shapes.isCrept
                              ? (second ? relaxCells<true, true> : relaxCells<true, false>)
                              : (second ? relaxCells<false, true> : relaxCells<false, false>);
        work(begin, end, parity, points, shapes, keep, relaxed);
    });
}

// The largest squares and the smallest area of one lane, because compilers do not vectorise a
// single maximum.
struct LaneRanges {
    static constexpr std::size_t count = 16;
    float largest[count], least[count];
};

template <bool second>
HWY_INLINE void takeStretch(const RowOfPoints& p, const RowOfSizes& sizes, const float* moving,
                            std::size_t i, bool even, std::size_t lane, LaneRanges& ranges) {
    const float inverseX = sizes.inversesX[i], inverseZ = sizes.inverseZ;
    const numerics::EdgePair<float> e =
        cellEdges(p, i, second, even != second, sizes.edgesX[i], sizes.edgeZ);
    const float squares = (e.hx * e.hx + e.hz * e.hz) * inverseX * inverseX +
                          (e.vx * e.vx + e.vz * e.vz) * inverseZ * inverseZ;
    const float area = (e.hx * e.vz - e.vx * e.hz) * inverseX * inverseZ;
    const bool moves = moving[i] > 0;
    const float ownSquares = moves ? squares : 0, ownArea = moves ? area : 1;
    const float largest = ranges.largest[lane], least = ranges.least[lane];
    ranges.largest[lane] = largest > ownSquares ? largest : ownSquares;
    ranges.least[lane] = least < ownArea ? least : ownArea;
}

StretchRange stretchRange(std::size_t cells, unsigned parity, const RowOfPoints& p,
                          const std::array<const float*, 2>& moving, const RowOfSizes& sizes) {
    LaneRanges ranges;
    for (std::size_t lane = 0; lane < LaneRanges::count; ++lane) {
        ranges.largest[lane] = 0;
        ranges.least[lane] = 1;
    }
    inWholeVectors(cells, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; i += LaneRanges::count) {
            const std::size_t count = end - i < LaneRanges::count ? end - i : LaneRanges::count;
            DIPWRIGHT_INDEPENDENT_LOOP
            for (std::size_t lane = 0; lane < count; ++lane) {
                const bool even = ((unsigned(i + lane) + parity) & 1u) == 0;
                takeStretch<false>(p, sizes, moving[0], i + lane, even, lane, ranges);
                takeStretch<true>(p, sizes, moving[1], i + lane, even, lane, ranges);
            }
        }
    });
    StretchRange range{0, 1};
    for (std::size_t lane = 0; lane < LaneRanges::count; ++lane) {
        range.largestSquares = range.largestSquares > ranges.largest[lane] ? range.largestSquares
                                                                           : ranges.largest[lane];
        range.leastArea =
            range.leastArea < ranges.least[lane] ? range.leastArea : ranges.least[lane];
    }
    return range;
}

void addForces(std::size_t cells, float sign, const float* edge, const float* left,
               const float* right, float* out) {
    const Vector signs = hn::Set(lanes, sign);
    out[0] += -edge[0] + sign * left[0];
    forRow(
        1, cells, out,
        [&](std::size_t i) HWY_ATTR {
            const Vector edges = hn::Sub(load(edge + i - 1), load(edge + i));
            const Vector sides = hn::Mul(signs, hn::Add(load(left + i), load(right + i - 1)));
            return hn::Add(load(out + i), hn::Add(edges, sides));
        },
        [&](std::size_t i) {
            return out[i] + ((edge[i - 1] - edge[i]) + sign * (left[i] + right[i - 1]));
        });
    out[cells] += edge[cells - 1] + sign * right[cells - 1];
}

} // namespace

} // namespace dipwright::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dipwright::cpu {

namespace {

HWY_EXPORT(rowProducts);
HWY_EXPORT(rowSquares);
HWY_EXPORT(rowWeightedSquares);
HWY_EXPORT(rowLargest);
HWY_EXPORT(addScaled);
HWY_EXPORT(scaledRow);
HWY_EXPORT(addWeighted);
HWY_EXPORT(addDifference);
HWY_EXPORT(multiplyBy);
HWY_EXPORT(gradientRow);
HWY_EXPORT(hessianRow);
HWY_EXPORT(stiffnessRow);
HWY_EXPORT(relaxRow);
HWY_EXPORT(stretchRange);
HWY_EXPORT(addForces);

} // namespace

std::int64_t rowProducts(const RowOfPairs& a, const RowOfPairs& b, float factor,
                         std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(rowProducts)(a, b, factor, count);
}
numerics::SquareSum rowSquares(const RowOfPairs& a, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(rowSquares)(a, count);
}
numerics::SquareSum rowWeightedSquares(const float* weight, const RowOfPairs& a,
                                       std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(rowWeightedSquares)(weight, a, count);
}
float rowLargest(const float* a, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(rowLargest)(a, count);
}
void addScaled(std::size_t count, float factor, const float* a, float* out) {
    HWY_DYNAMIC_DISPATCH(addScaled)(count, factor, a, out);
}
void scaledRow(std::size_t count, float factor, const float* a, float* out) {
    HWY_DYNAMIC_DISPATCH(scaledRow)(count, factor, a, out);
}
void addWeighted(std::size_t count, float factor, const float* weight, const float* a, float* out) {
    HWY_DYNAMIC_DISPATCH(addWeighted)(count, factor, weight, a, out);
}
void addDifference(std::size_t count, float factor, const float* weight, const float* a,
                   const float* b, float* out) {
    HWY_DYNAMIC_DISPATCH(addDifference)(count, factor, weight, a, b, out);
}
void multiplyBy(std::size_t count, const float* a, float* out) {
    HWY_DYNAMIC_DISPATCH(multiplyBy)(count, a, out);
}
void gradientRow(std::size_t cells, unsigned parity, const RowOfPoints& points,
                 const RowOfShapes& shapes, float gatheredResistance,
                 const RowOfStates<float*>& states, const RowOfForces& forces) {
    HWY_DYNAMIC_DISPATCH(gradientRow)
    (cells, parity, points, shapes, gatheredResistance, states, forces);
}
void hessianRow(std::size_t cells, unsigned parity, const RowOfPoints& direction,
                const RowOfShapes& shapes, const RowOfStates<const float*>& states,
                numerics::Tangent tangent, const RowOfForces& forces) {
    HWY_DYNAMIC_DISPATCH(hessianRow)(cells, parity, direction, shapes, states, tangent, forces);
}
void stiffnessRow(std::size_t cells, const RowOfShapes& shapes,
                  const RowOfStates<const float*>& states, const Lines<float>& first,
                  const Lines<float>& second) {
    HWY_DYNAMIC_DISPATCH(stiffnessRow)(cells, shapes, states, first, second);
}
void relaxRow(std::size_t cells, unsigned parity, bool second, const RowOfPoints& points,
              const RowOfShapes& shapes, float keep, const Lines<float>& relaxed) {
    HWY_DYNAMIC_DISPATCH(relaxRow)(cells, parity, second, points, shapes, keep, relaxed);
}
StretchRange stretchRange(std::size_t cells, unsigned parity, const RowOfPoints& points,
                          const std::array<const float*, 2>& moving, const RowOfSizes& sizes) {
    return HWY_DYNAMIC_DISPATCH(stretchRange)(cells, parity, points, moving, sizes);
}
void addForces(std::size_t cells, float sign, const float* edge, const float* left,
               const float* right, float* out) {
    HWY_DYNAMIC_DISPATCH(addForces)(cells, sign, edge, left, right, out);
}

} // namespace dipwright::cpu
#endif
