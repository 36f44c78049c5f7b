// Defines a film triangle that crosses the contact line: partly on the body, partly on the water.
//
// It differs from a floating triangle in three ways.
//
// 1. Its adhered corners are unfolded (ContactPath.h). This adds an offset to its edges.
// 2. Only its floating part strains. Laid film keeps its strain. So a change of the triangle's
//    length across the contact line belongs to its floating fraction f:
//    F = F_whole + (1/f − 1)(F_whole − F_anchor) M Mᵀ.  F_whole is the gradient of the whole
//    triangle and F_anchor the floating part's gradient at the start of the step. M is the line's
//    normal at rest. f is the value in the middle of the step: on average, film is laid with the
//    mean of the strains before and after the step.
// 3. Only its floating part, beyond the contact line, pulls at its free corners. So a virtual
//    displacement falls from its value at the corner to zero on the line, not at the adhered
//    corner. Let the stress P be constant and the test functions linear along the sides. Then the
//    force on a free corner is  ½ P Σ share(e) (ℓ n)(e)  over the two sides e that meet there.
//    (ℓ n) is the side's length times its outward normal at rest, and share(e) the side's floating
//    fraction. With all shares 1 this is the ordinary constant-strain force.
//
// Without points 2 and 3, the film would be laid with the strain that it has half a cell inside the
// contact line. This error is of first order in the spacing.
#pragma once

#include "production/formulas/GridTriangle.h"

namespace dipwright::numerics {

template <typename Real>
struct CrossingTriangle {
    std::uint32_t cell{}; // row·(columns − 1) + column
    bool second{};        // true for the triangle with the cell's second (higher) horizontal edge
    bool thirdOnRight{};  // its vertical edge is the cell's right one
    // Offsets of the horizontal and the vertical edge, from lower to higher grid index.
    Real hx{}, hz{}, vx{}, vz{};
    // Floating fractions of the horizontal, vertical and diagonal side.
    Real horizontalShare = 1, verticalShare = 1, diagonalShare = 1;
    // Whether these corners are free: the corner that the horizontal and vertical sides share, the
    // other end of the horizontal side, and the other end of the vertical side.
    bool sharedFree{}, horizontalFree{}, verticalFree{};
    // Unit normal of the contact line in the water plane; it points away from the body. `floating`
    // is the triangle's floating fraction along this normal. A zero normal means that no contact
    // line was found.
    Real normalX{}, normalZ{}, floating = 1;
    // Vertical component of the body's unit normal on the contact line: positive past the equator.
    Real upwards{};
};

// The state of a crossing triangle at the start of a step.
template <typename Real>
struct CrossingAnchor {
    Matrix2<Real> gradient; // F of the floating part at the start
    Real floating = 1;      // f at the start of the step
    Real gain{};            // 1/f − 1 in the middle of the step
    Real mx{}, mz{};        // M
};

// Lower limit of the floating fraction, used when the line has almost reached the free corners.
// With a smaller fraction, the slightest force would move a free corner.
inline constexpr double leastFloatingFraction = 0.3;

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline CrossingAnchor<Real>
crossingAnchor(const CrossingTriangle<Real>& triangle, const Matrix2<Real>& gradient) {
    // Fᵀ maps the normal of the line back to the rest state.
    const Real mx = gradient.a * triangle.normalX + gradient.c * triangle.normalZ;
    const Real mz = gradient.b * triangle.normalX + gradient.d * triangle.normalZ;
    const Real size = std::sqrt(mx * mx + mz * mz);
    if (!(size > Real(0.01))) {
        return {gradient, triangle.floating, Real(0), Real(0), Real(0)};
    }
    return {gradient, triangle.floating, Real(0), mx / size, mz / size};
}

// Sets the anchor's gain for a step at whose end the triangle has the state `end`.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline CrossingAnchor<Real>
anchorOverStep(CrossingAnchor<Real> anchor, const CrossingTriangle<Real>& end) {
    const Real middle = (anchor.floating + end.floating) / Real(2);
    anchor.gain = Real(1) / std::fmax(middle, Real(leastFloatingFraction)) - Real(1);
    return anchor;
}

// Returns the change dF of the floating part for a change of the whole triangle.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> floatingChange(const CrossingAnchor<Real>& anchor,
                                                          const Matrix2<Real>& change) {
    const Real x = anchor.gain * (change.a * anchor.mx + change.b * anchor.mz);
    const Real z = anchor.gain * (change.c * anchor.mx + change.d * anchor.mz);
    return {change.a + x * anchor.mx, change.b + x * anchor.mz, change.c + z * anchor.mx,
            change.d + z * anchor.mz};
}

// Returns F of the floating part, from F of the whole triangle.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> floatingGradient(const CrossingAnchor<Real>& anchor,
                                                            const Matrix2<Real>& whole) {
    const Matrix2<Real>& start = anchor.gradient;
    const Matrix2<Real> change = floatingChange(
        anchor, {whole.a - start.a, whole.b - start.b, whole.c - start.c, whole.d - start.d});
    return {start.a + change.a, start.b + change.b, start.c + change.c, start.d + change.d};
}

// Returns a crossing triangle's edges with its held corners unfolded.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline EdgePair<Real> unfoldedEdges(const EdgePair<Real>& edges,
                                                          const CrossingTriangle<Real>& triangle) {
    return {edges.hx + triangle.hx, edges.hz + triangle.hz, edges.vx + triangle.vx,
            edges.vz + triangle.vz};
}

// Returns the inverse rest shape of a triangle after a step in which it crossed the contact line.
// With edges E = F_whole·D, the new rest shape is F⁻¹·E, so the whole triangle has the gradient F
// of its floating part. `keep`: the remaining share of its stretch.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real>
relaxedCrossingShape(const CrossingAnchor<Real>& anchor, const Matrix2<Real>& whole,
                     const Matrix2<Real>& inverseShape, Real keep) {
    const Matrix2<Real> floating = floatingGradient(anchor, whole);
    const bool sound = whole.a * whole.d - whole.b * whole.c > Real(0.01) &&
                       floating.a * floating.d - floating.b * floating.c > Real(0.01);
    return sound ? relaxedInverseShape(inverseShape * (inverse(whole) * floating), floating, keep)
                 : inverseShape;
}

// Returns the forces on the edges of a crossing triangle. `P` is the stress, `inverseShape` the
// inverse of the rest shape, `area` the triangle's weight.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline EdgePair<Real>
crossingForces(const CrossingTriangle<Real>& triangle, const Matrix2<Real>& P,
               const Matrix2<Real>& inverseShape, Real area) {
    const Real determinant =
        Real(1) / (inverseShape.a * inverseShape.d - inverseShape.b * inverseShape.c);
    // Rest edges from the shared corner s: to corner h along the horizontal edge, and to corner v
    // along the vertical edge.
    const Real signH = triangle.thirdOnRight ? Real(-1) : Real(1);
    const Real signV = triangle.second ? Real(-1) : Real(1);
    const Real hX = signH * inverseShape.d * determinant,
               hZ = -signH * inverseShape.c * determinant;
    const Real vX = -signV * inverseShape.b * determinant,
               vZ = signV * inverseShape.a * determinant;
    const Real orientation = hX * vZ - hZ * vX > Real(0) ? Real(1) : Real(-1);
    // Thickness of the film after creep: its weight divided by its rest area.
    const Real half = orientation * area / std::fabs(determinant);
    const Real shareH = half * triangle.horizontalShare, shareV = half * triangle.verticalShare;
    const Real shareD = half * triangle.diagonalShare;
    // Weighted outward normals of the sides s→h, h→v and v→s, times the lengths of the sides.
    const Real nHx = shareH * hZ, nHz = -shareH * hX;
    const Real nDx = shareD * (vZ - hZ), nDz = -shareD * (vX - hX);
    const Real nVx = -shareV * vZ, nVz = shareV * vX;
    const auto forceX = [&](Real nx, Real nz) { return P.a * nx + P.b * nz; };
    const auto forceZ = [&](Real nx, Real nz) { return P.c * nx + P.d * nz; };
    const Real sharedX = forceX(nHx + nVx, nHz + nVz), sharedZ = forceZ(nHx + nVx, nHz + nVz);
    Real endHx = forceX(nHx + nDx, nHz + nDz), endHz = forceZ(nHx + nDx, nHz + nDz);
    Real endVx = forceX(nVx + nDx, nVz + nDz), endVz = forceZ(nVx + nDx, nVz + nDz);
    // The force on a held corner does not matter, so it balances the other forces.
    if (triangle.sharedFree) {
        if (!triangle.horizontalFree) {
            if (!triangle.verticalFree) {
                endVx = endVz = Real(0);
            }
            endHx = -sharedX - endVx;
            endHz = -sharedZ - endVz;
        } else {
            endVx = -sharedX - endHx;
            endVz = -sharedZ - endHz;
        }
    }
    return {signH * endHx, signH * endHz, signV * endVx, signV * endVz};
}

} // namespace dipwright::numerics
