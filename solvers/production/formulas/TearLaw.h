// Defines when film tears or folds (docs/film-model.md, "Where film does not go"), for all devices.
// PrincipalStretch::isTorn in core/film applies the same law to drawings and counts.
#pragma once

#include "production/formulas/GridTriangle.h"

namespace dipwright::numerics {

// The stretch of a triangle whose undeformed edges were spacingX and spacingZ.
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

// Returns whether film tears: it is stretched to more than `limit` times its length in some
// direction, or its area.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isTorn(const TriangleStretch<Real>& stretch, Real limit) {
    return stretch.larger > limit || stretch.area > limit;
}
// Returns whether film is turned inside out. Real film has left the plane by then. In the plane,
// its forces may have no equilibrium.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isFolded(const TriangleStretch<Real>& stretch) {
    return stretch.area < Real(0);
}

// Returns whether some of several triangles may be torn or folded. `squares`: an upper bound of λ1²
// + λ2², the sum of the squared entries of the deformation gradient. `leastArea`: a lower bound of
// λ1 λ2. This quick test skips whole rows of film: while the sum is small, neither the larger
// stretch nor, as λ1 λ2 ≤ (λ1² + λ2²)/2, the area can exceed the limit. Change it together with
// isTorn() and isFolded().
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool mayBeTornOrFolded(Real squares, Real leastArea, Real limit) {
    return squares > limit * limit || squares > Real(2) * limit || leastArea < Real(0);
}

// Limits how far the rest shape of a triangle on the contact line may creep from the undeformed
// one, as a factor in length in either direction. Its floating part can be so small that its
// gradient, applied to the whole triangle step after step, would grow without bound. Beyond this
// limit the shape is kept.
inline constexpr double mostCrept = 16;

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isShapeWithinLimits(const Matrix2<Real>& inverseShape,
                                                      Real spacingX, Real spacingZ) {
    // F⁻¹ of the rest shape relative to the undeformed one. Its larger singular value is at most
    // the root of the sum of squares. The smaller one is the determinant divided by the larger one.
    const Matrix2<Real> F{inverseShape.a * spacingX, inverseShape.b * spacingX,
                          inverseShape.c * spacingZ, inverseShape.d * spacingZ};
    const Real size = std::sqrt(F.a * F.a + F.b * F.b + F.c * F.c + F.d * F.d);
    return size < Real(mostCrept) && (F.a * F.d - F.b * F.c) * Real(mostCrept) > size;
}

} // namespace dipwright::numerics
