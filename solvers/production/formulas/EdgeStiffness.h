// Computes how the forces on a triangle's two edges respond to changes of these edges. Combines the
// triangles of a cell into a stiffness between the cell's points. Every device assembles the
// preconditioner of the film's equilibrium (StiffnessMultigrid) from this.
#pragma once

#include "production/formulas/CrossingTriangle.h"

namespace dipwright::numerics {

// Holds 2 × 2 blocks: the change of the force on the horizontal (h) or vertical (v) edge per change
// of the horizontal or vertical edge.
template <typename Real>
struct EdgeStiffness {
    Matrix2<Real> hh, hv, vh, vv;
};

// Returns the stiffness of a floating triangle, made positive semi-definite (Tangent::Projected).
// The derivative of P is 2 dF + `resists` (R : dF) R + `turns` (RJ : dF) RJ, with the factors of
// tangentFactors() (docs/film-model.md, "The film's energy"). So the stiffness is a multiple of the
// identity plus two dyads. It is symmetric to the last bit.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP EdgeStiffness<Real>
edgeStiffness(const Matrix2<Real>& shape, const StressState<Real>& state, Real area) {
    const TangentFactors<Real> factors = tangentFactors(state, Tangent::Projected);
    const Real cosine = state.cosine, sine = state.sine;
    const Real a = shape.a, b = shape.b, c = shape.c, d = shape.d;
    // R and RJ, converted to the edges.
    const Real hx = cosine * a - sine * b, hz = sine * a + cosine * b;
    const Real vx = cosine * c - sine * d, vz = sine * c + cosine * d;
    const Real resists = area * factors.resists, turns = area * factors.turns;
    const Real hh = Real(2) * area * (a * a + b * b), hv = Real(2) * area * (a * c + b * d),
               vv = Real(2) * area * (c * c + d * d);
    // RJ is R rotated by 90°: (x, z) of an edge becomes (−z, x).
    const Matrix2<Real> mixed{
        hv + resists * hx * vx + turns * hz * vz, resists * hx * vz - turns * hz * vx,
        resists * hz * vx - turns * hx * vz, hv + resists * hz * vz + turns * hx * vx};
    return {{hh + resists * hx * hx + turns * hz * hz, (resists - turns) * hx * hz,
             (resists - turns) * hx * hz, hh + resists * hz * hz + turns * hx * hx},
            mixed,
            {mixed.a, mixed.c, mixed.b, mixed.d},
            {vv + resists * vx * vx + turns * vz * vz, (resists - turns) * vx * vz,
             (resists - turns) * vx * vz, vv + resists * vz * vz + turns * vx * vx}};
}

// Returns the stiffness of a triangle that crosses the contact line. It is not symmetric.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline EdgeStiffness<Real>
edgeStiffness(const CrossingTriangle<Real>& triangle, const CrossingAnchor<Real>& anchor,
              const Matrix2<Real>& shape, const StressState<Real>& state, Real area) {
    const auto answer = [&](const EdgePair<Real>& change) {
        return crossingForces(triangle,
                              stressDerivative(floatingChange(anchor, gradientOf(change, shape)),
                                               state, Tangent::Projected),
                              shape, area);
    };
    const Real one(1), none(0);
    const EdgePair<Real> hx = answer({one, none, none, none}), hz = answer({none, one, none, none}),
                         vx = answer({none, none, one, none}), vz = answer({none, none, none, one});
    return {{hx.hx, hz.hx, hx.hz, hz.hz},
            {vx.hx, vz.hx, vx.hz, vz.hz},
            {hx.vx, hz.vx, hx.vz, hz.vz},
            {vx.vx, vz.vx, vx.vz, vz.vz}};
}

// The points of a cell.
enum class CellPoint : int { LowerLeft, LowerRight, UpperLeft, UpperRight };

// The change of the force on one point of a cell per displacement of each of the cell's points.
template <typename Real>
struct CellRow {
    Matrix2<Real> toLowerLeft, toLowerRight, toUpperLeft, toUpperRight;
};

namespace detail {

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> plus(const Matrix2<Real>& m, const Matrix2<Real>& n) {
    return {m.a + n.a, m.b + n.b, m.c + n.c, m.d + n.d};
}
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> minus(const Matrix2<Real>& m, const Matrix2<Real>& n) {
    return {m.a - n.a, m.b - n.b, m.c - n.c, m.d - n.d};
}

} // namespace detail

// Computes a row of the cell's stiffness from its two triangles. In an even cell, the first
// triangle (on the lower edge) has the right vertical edge, and the second triangle has the left
// one. A force on an edge acts with + on the edge's higher end and with − on its lower end. A
// point's displacement changes the edge with the same signs.
template <CellPoint point, typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP CellRow<Real>
cellRow(const EdgeStiffness<Real>& first, const EdgeStiffness<Real>& second, bool even) {
    using detail::minus;
    using detail::plus;
    constexpr bool isLower = point == CellPoint::LowerLeft || point == CellPoint::LowerRight;
    constexpr bool isLeft = point == CellPoint::LowerLeft || point == CellPoint::UpperLeft;
    const Real one(1), none(0);
    const Real isEven = even ? one : none, isOdd = even ? none : one;
    // The blocks of the point's horizontal edge: with itself, with the left and right vertical
    // edge, and the transposed blocks.
    const EdgeStiffness<Real>& along = isLower ? first : second;
    const Real ofRight = isLower ? isEven : isOdd, ofLeft = isLower ? isOdd : isEven;
    // The blocks of the point's vertical edge: with itself, and with the lower and upper horizontal
    // edge.
    const Real ofFirst = isLeft ? isOdd : isEven, ofSecond = isLeft ? isEven : isOdd;
    const Matrix2<Real> vv = plus(scaled(first.vv, ofFirst), scaled(second.vv, ofSecond));
    const Matrix2<Real> toLower = scaled(first.vh, ofFirst), toUpper = scaled(second.vh, ofSecond);
    const Matrix2<Real> toLeft = scaled(along.hv, ofLeft), toRight = scaled(along.hv, ofRight);
    const Real signH = isLeft ? -one : one, signV = isLower ? -one : one;
    const auto signedSum = [&](const Matrix2<Real>& h, const Matrix2<Real>& v) {
        return Matrix2<Real>{signH * h.a + signV * v.a, signH * h.b + signV * v.b,
                             signH * h.c + signV * v.c, signH * h.d + signV * v.d};
    };
    // The change of the force on the point per change of each of the cell's edges.
    const Matrix2<Real> zero{};
    const Matrix2<Real> lower = signedSum(isLower ? along.hh : zero, toLower);
    const Matrix2<Real> upper = signedSum(isLower ? zero : along.hh, toUpper);
    const Matrix2<Real> left = signedSum(toLeft, isLeft ? vv : zero);
    const Matrix2<Real> right = signedSum(toRight, isLeft ? zero : vv);
    return {scaled(plus(lower, left), -one), minus(lower, right), minus(left, upper),
            plus(upper, right)};
}

} // namespace dipwright::numerics
