// The law by which film tears (docs/film-model.md, Tearing), on every device. What is drawn and
// counted as torn afterwards goes by the same law, PrincipalStretch::isTorn in core/film.
#pragma once

#include "production/formulas/GridTriangle.h"

namespace dipwright::numerics {

// Whether film is stretched to more than `limit` times its length in some direction or its area:
// then it tears. `edges` of the triangle; the undeformed ones are spacingX and spacingZ long.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool isTorn(const EdgePair<Real>& edges, Real spacingX, Real spacingZ,
                                         Real limit) {
    const Matrix2<Real> F{edges.hx / spacingX, edges.vx / spacingZ, edges.hz / spacingX,
                          edges.vz / spacingZ};
    const Real sum = F.a + F.d, skew = F.c - F.b, difference = F.a - F.d, shear = F.c + F.b;
    const Real larger =
        (std::sqrt(sum * sum + skew * skew) + std::sqrt(difference * difference + shear * shear)) /
        Real(2);
    return larger > limit || F.a * F.d - F.b * F.c > limit;
}

// Whether a triangle may be torn of which λ1² + λ2², the sum of squares of the deformation
// gradient's entries, is `squares`. A quick look, which lets whole rows of film be passed over:
// neither the larger stretch nor, with λ1 λ2 ≤ (λ1² + λ2²)/2, the area can be past the limit while
// that sum is small. To be changed with isTorn().
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool mayBeTorn(Real squares, Real limit) {
    return squares > limit * limit || squares > Real(2) * limit;
}

} // namespace dipwright::numerics
