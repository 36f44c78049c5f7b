// The laws by which film tears or folds (docs/film-model.md, Where film does not go), on every
// device. What is drawn and counted as torn afterwards goes by the same law,
// PrincipalStretch::isTorn in core/film.
#pragma once

#include "production/formulas/GridTriangle.h"

namespace dipwright::numerics {

// Of a triangle whose edges were spacingX and spacingZ long before anything happened: how much it
// is stretched against then.
template <typename Real>
struct TriangleStretch {
    Real larger{}; // λ1
    Real area{};   // λ1 λ2; negative where the triangle is turned inside out
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

// Whether film is stretched to more than `limit` times its length in some direction or its area:
// then it tears.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isTorn(const TriangleStretch<Real>& stretch, Real limit) {
    return stretch.larger > limit || stretch.area > limit;
}
// Whether film is turned inside out. Real film has long gone out of the plane there; in the plane
// its forces may have no rest.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isFolded(const TriangleStretch<Real>& stretch) {
    return stretch.area < Real(0);
}

// Whether triangles may be torn or folded of which λ1² + λ2², the sum of squares of the deformation
// gradient's entries, is at most `squares` and λ1 λ2 at least `leastArea`. A quick look, which lets
// whole rows of film be passed over: neither the larger stretch nor, with λ1 λ2 ≤ (λ1² + λ2²)/2,
// the area can be past the limit while that sum is small. To be changed with isTorn() and
// isFolded().
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool mayBeLost(Real squares, Real leastArea, Real limit) {
    return squares > limit * limit || squares > Real(2) * limit || leastArea < Real(0);
}

// How far the rest shape of a triangle on the contact line may have crept from the undeformed one,
// in length, either way. What floats of it can be so little that its gradient, taken for the whole
// triangle step after step, grows without bound: past this the shape stays.
inline constexpr double mostCrept = 16;

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isSoundShape(const Matrix2<Real>& inverseShape, Real spacingX,
                                               Real spacingZ) {
    // Of F⁻¹ of the rest shape against the undeformed one: the larger singular value is at most the
    // root of the sum of squares, and the smaller one is the determinant over it.
    const Matrix2<Real> F{inverseShape.a * spacingX, inverseShape.b * spacingX,
                          inverseShape.c * spacingZ, inverseShape.d * spacingZ};
    const Real size = std::sqrt(F.a * F.a + F.b * F.b + F.c * F.c + F.d * F.d);
    return size < Real(mostCrept) && (F.a * F.d - F.b * F.c) * Real(mostCrept) > size;
}

} // namespace dipwright::numerics
