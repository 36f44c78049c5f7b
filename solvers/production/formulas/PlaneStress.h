// The elastic law of the production film: constant-strain triangles in the water plane.
//
// Let F be the deformation gradient, F = R·U its polar decomposition, and s = tr U. The energy per
// rest area is
//
//     W = μ |F − R|² + (λ/2)(s − 2)²,
//
// This is the corotated (Biot strain) plane-stress law. Poisson's ratio 1/3 makes λ = μ. Only the
// ratio matters in equilibrium, so both are 1. In two dimensions, R needs no decomposition: for F =
// [a b; c d], s = √((a + d)² + (c − b)²), cos = (a + d)/s, sin = (c − b)/s.
//
// Gathered film. With δ = λ1 − λ2, the same law reads W = δ²/2 + (s − 2)². Below a mean stretch s/2
// of 2/3, triangles could give way by rotating against each other in the plane. The direction would
// depend only on the grid. (W is rank-one convex where the second term's derivative g′ is at least
// −s.) Real film wrinkles out of the plane instead, and then has hardly any resistance. So below
// the mean stretch 4/5, the second term continues as g′ = −s/2, which equals 2 (s − 2) there. The
// film keeps a single equilibrium and gathers evenly. The two laws blend smoothly over 0.05 of mean
// stretch on each side. Film at its free edge comes to rest in this range, where Newton's method
// would alternate at a kink.
#pragma once

#include "common/HostDevice.h"

#include <cmath>

namespace dipwright::numerics {

// A 2 × 2 matrix [a b; c d]. The first column is the film's X direction, the second its Z
// direction. Each column holds x and z components.
template <typename Real>
struct Matrix2 {
    Real a{}, b{}, c{}, d{};
};

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> operator*(const Matrix2<Real>& m,
                                                     const Matrix2<Real>& n) {
    return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c,
            m.c * n.b + m.d * n.d};
}
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> scaled(const Matrix2<Real>& m, Real factor) {
    return {m.a * factor, m.b * factor, m.c * factor, m.d * factor};
}

// Returns h′(s) of gathered film if gathering begins at the mean stretch `gatheringStretch`; −3/2
// for 4/5. The whole stress is P = 2F + h(s)·R, see stress().
DIPWRIGHT_HOST_DEVICE constexpr double gatheredResistance(double gatheringStretch) {
    return 1 - 2 / gatheringStretch;
}
// Half width, in s, of the range around the start of gathering in which the two laws blend.
inline constexpr double gatheringWidth = 0.1;

// The values at the linearisation point that the Hessian needs.
template <typename Real>
struct StressState {
    Real cosine{}, sine{}; // components of the rotation R
    Real turn{};           // h(s)/s, coefficient of the derivative of R
    Real resists{};        // h′(s), coefficient of the derivative of s
};

// Returns P = ∂W/∂F at F, and the state for stressDerivative.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP Matrix2<Real>
stress(const Matrix2<Real>& F, Real gatheredResistance, StressState<Real>& state) {
    const Real sum = F.a + F.d, skew = F.c - F.b;
    const Real s = std::sqrt(sum * sum + skew * skew) + Real(1e-12);
    const Real inverse = Real(1) / s;
    const Real cosine = sum * inverse, sine = skew * inverse;
    // P = 2(F − R) + (s − 2)R = 2F + (s − 4)R, or 2F + h′sR where the film gathers. The larger of
    // the two factors on R counts: max(a, b) = (a + b + |a − b|)/2, with a parabola instead of |a −
    // b| near zero.
    const Real change = Real(1) - gatheredResistance; // change of h′ where gathering begins
    const Real firm = s - Real(4), gathered = gatheredResistance * s;
    const Real difference = firm - gathered, width = change * Real(gatheringWidth);
    const Real share = difference / width; // outside the blend, its absolute value is above 1
    const Real within = share < Real(-1) ? Real(-1) : share > Real(1) ? Real(1) : share;
    const Real size = difference < Real(0) ? -difference : difference;
    const Real apart = within == share ? (difference * share + width) / Real(2) : size;
    const Real rotation = (firm + gathered + apart) / Real(2);
    state = {cosine, sine, rotation * inverse,
             (Real(1) + gatheredResistance + change * within) / Real(2)};
    return {Real(2) * F.a + rotation * cosine, Real(2) * F.b - rotation * sine,
            Real(2) * F.c + rotation * sine, Real(2) * F.d + rotation * cosine};
}

// Selects the derivative of the stress. With the true derivative, Newton's method converges. The
// positive semi-definite (projected) derivative leads downhill from anywhere.
enum class Tangent { True, Projected };

// The coefficients h′ and h/s. The changes of s and of R contribute with them, in addition to 2 dF.
template <typename Real>
struct TangentFactors {
    Real resists{}, turns{};
};

// Projected: limits both coefficients to at least −1. At −1, a change of R or of s alone costs no
// energy when the film is compressed overall.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline TangentFactors<Real> tangentFactors(const StressState<Real>& state,
                                                                 Tangent tangent) {
    const auto atLeast = [tangent](Real value) {
        return tangent == Tangent::True || value > Real(-1) ? value : Real(-1);
    };
    return {atLeast(state.resists), atLeast(state.turn)};
}

// Returns dP for a change dF at the point of `state`. The rotation changes by dR = (RJ : dF)/s ·
// RJ, which contributes with h/s.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP Matrix2<Real>
stressDerivative(const Matrix2<Real>& dF, const StressState<Real>& state, Tangent tangent) {
    const Real cosine = state.cosine, sine = state.sine;
    const TangentFactors<Real> factors = tangentFactors(state, tangent);
    const Real stretch =
        factors.resists * (cosine * (dF.a + dF.d) + sine * (dF.c - dF.b));             // R : dF
    const Real turn = factors.turns * (cosine * (dF.c - dF.b) - sine * (dF.a + dF.d)); // RJ : dF
    return {Real(2) * dF.a + stretch * cosine - turn * sine,
            Real(2) * dF.b - stretch * sine - turn * cosine,
            Real(2) * dF.c + stretch * sine + turn * cosine,
            Real(2) * dF.d + stretch * cosine - turn * sine};
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real determinant(const Matrix2<Real>& m) {
    return m.a * m.d - m.b * m.c;
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> inverse(const Matrix2<Real>& m) {
    const Real scale = Real(1) / (m.a * m.d - m.b * m.c);
    return {m.d * scale, -m.b * scale, -m.c * scale, m.a * scale};
}

// Returns the inverse rest shape after the stretch U = RᵀF has relaxed to I + (U − I)·keep. `keep`
// is exp(−Δt/τ); 0 means viscous, 1 elastic. With edges E = F·D and rest shape D, the new rest
// shape is U'⁻¹·U·D.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP Matrix2<Real>
relaxedInverseShape(const Matrix2<Real>& inverseShape, const Matrix2<Real>& F, Real keep) {
    const Real sum = F.a + F.d, skew = F.c - F.b;
    const Real s = std::sqrt(sum * sum + skew * skew) + Real(1e-12);
    const Real cosine = sum / s, sine = skew / s;
    const Matrix2<Real> U{cosine * F.a + sine * F.c, cosine * F.b + sine * F.d,
                          cosine * F.c - sine * F.a, cosine * F.d - sine * F.b};
    // Inside out or flat: let it recover elastically.
    const bool isSound = U.a * U.d - U.b * U.c > Real(1e-6);
    const Matrix2<Real> kept{Real(1) + (U.a - Real(1)) * keep, U.b * keep, U.c * keep,
                             Real(1) + (U.d - Real(1)) * keep};
    const Matrix2<Real> relaxed = inverseShape * (inverse(U) * kept);
    return {isSound ? relaxed.a : inverseShape.a, isSound ? relaxed.b : inverseShape.b,
            isSound ? relaxed.c : inverseShape.c, isSound ? relaxed.d : inverseShape.d};
}

} // namespace dipwright::numerics
