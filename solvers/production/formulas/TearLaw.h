// Defines when film tears or folds (docs/film-model.md, "Where film does not go"), for all devices.
// PrincipalStretch::isTorn in core/film applies the same law to drawings and counts.
#pragma once

#include "production/formulas/GridTriangle.h"

namespace dipwright::numerics {

// The stretch of a triangle whose undeformed edges were spacingX and spacingZ long.
template <typename Real>
struct TriangleStretch {
    Real larger{}; // λ1
    Real area{};   // λ1 λ2; negative if the triangle is turned inside out
};
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline TriangleStretch<Real> triangleStretch(const EdgePair<Real>& edges,
                                                                   Real spacingX, Real spacingZ) {
    const Matrix2<Real> F{edges.hx / spacingX, edges.vx / spacingZ, edges.hz / spacingX,
                          edges.vz / spacingZ};
    const Real sum = F.a + F.d, skew = F.c - F.b, difference = F.a - F.d, shear = F.c + F.b;
    return {
        (std::sqrt(sum * sum + skew * skew) + std::sqrt(difference * difference + shear * shear)) /
            Real(2),
        F.a * F.d - F.b * F.c};
}

// Returns whether film tears: whether its length in some direction, or its area, has grown to more
// than `limit` times the rest value.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isTorn(const TriangleStretch<Real>& stretch, Real limit) {
    return stretch.larger > limit || stretch.area > limit;
}
// Returns whether film is turned inside out. Real film has left the plane by then. In the plane,
// the forces of such film may have no equilibrium.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isFolded(const TriangleStretch<Real>& stretch) {
    return stretch.area < Real(0);
}

// Returns whether some of several triangles may be torn or folded. `squares` is an upper bound of
// λ1² + λ2², the sum of the squared entries of the deformation gradient. `leastArea` is a lower
// bound of λ1 λ2. This quick test skips whole rows of film. While `squares` is small, the larger
// stretch cannot exceed the limit. Nor can the area, as λ1 λ2 ≤ (λ1² + λ2²)/2. The margin covers
// the rounding errors, so that skipping rows changes nothing. Change this function together with
// isTorn() and isFolded().
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool mayBeTornOrFolded(Real squares, Real leastArea, Real limit) {
    const Real margin = Real(1e-4), most = (Real(1) - margin) * limit;
    return squares > most * most || squares > Real(2) * most || leastArea < margin;
}

// The largest creep of the rest shape of a triangle on the contact line: the factor on its
// undeformed length in each direction. The triangle's floating part can be very small. Its
// gradient, applied to the whole triangle step after step, would then grow without bound. Beyond
// this limit, the rest shape is kept.
inline constexpr double largestCreepFactor = 16;

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isShapeWithinLimits(const Matrix2<Real>& inverseShape,
                                                      Real spacingX, Real spacingZ) {
    // F⁻¹ of the rest shape relative to the undeformed shape. Its larger singular value is at most
    // the root of the sum of squares. Its smaller singular value is the determinant divided by the
    // larger one.
    const Matrix2<Real> F{inverseShape.a * spacingX, inverseShape.b * spacingX,
                          inverseShape.c * spacingZ, inverseShape.d * spacingZ};
    const Real size = std::sqrt(F.a * F.a + F.b * F.b + F.c * F.c + F.d * F.d);
    return size < Real(largestCreepFactor) &&
           (F.a * F.d - F.b * F.c) * Real(largestCreepFactor) > size;
}

} // namespace dipwright::numerics
