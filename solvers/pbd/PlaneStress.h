// The elastic sheet of the production film: a constant-strain triangle in the water plane.
//
// Energy per rest area, with F the deformation gradient, F = R·U its polar decomposition and s = tr
// U:
//     W = μ |F − R|² + (λ/2)(s − 2)²,
// the corotated (Biot strain) plane-stress law. Poisson ratio 1/3 makes λ = μ, and as only the
// ratio matters in equilibrium both are 1. In two dimensions R comes without a decomposition: s =
// √((a + d)² + (c − b)²), cos = (a + d)/s, sin = (c − b)/s for F = [a b; c d].
#pragma once

#include "pbd/HostDevice.h"

#include <cmath>

namespace dipwright::pbd {

// A 2 × 2 matrix [a b; c d]: x and z of the film's X direction in the first column, of its Z
// direction in the second.
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

// What the Hessian needs to remember of the point of linearisation.
template <typename Real>
struct StressState {
    Real cosine{}, sine{}; // of the rotation R
    Real turn{};           // the coefficient of the rotation's own derivative, see stressDerivative
};

// P = ∂W/∂F at F, and the state for stressDerivative.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> stress(const Matrix2<Real>& F,
                                                  StressState<Real>& state) {
    const Real sum = F.a + F.d, skew = F.c - F.b;
    const Real s = std::sqrt(sum * sum + skew * skew) + Real(1e-12);
    const Real inverse = Real(1) / s;
    const Real cosine = sum * inverse, sine = skew * inverse;
    // P = 2(F − R) + (s − 2)R = 2F + (s − 4)R
    const Real rotation = s - Real(4);
    // dR = (RJ : dF)/s · RJ enters P with the factor (s − 4). Held at −1, where a pure rotation
    // costs nothing, when the film is compressed on the whole: the Hessian stays positive
    // semi-definite.
    const Real turn = rotation * inverse;
    state = {cosine, sine, turn > Real(-1) ? turn : Real(-1)};
    return {Real(2) * F.a + rotation * cosine, Real(2) * F.b - rotation * sine,
            Real(2) * F.c + rotation * sine, Real(2) * F.d + rotation * cosine};
}

// dP for a change dF, at the point where `state` was taken.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> stressDerivative(const Matrix2<Real>& dF,
                                                            const StressState<Real>& state) {
    const Real cosine = state.cosine, sine = state.sine;
    const Real stretch = cosine * (dF.a + dF.d) + sine * (dF.c - dF.b);             // R : dF
    const Real turn = state.turn * (cosine * (dF.c - dF.b) - sine * (dF.a + dF.d)); // RJ : dF
    return {Real(2) * dF.a + stretch * cosine - turn * sine,
            Real(2) * dF.b - stretch * sine - turn * cosine,
            Real(2) * dF.c + stretch * sine + turn * cosine,
            Real(2) * dF.d + stretch * cosine - turn * sine};
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> inverse(const Matrix2<Real>& m) {
    const Real scale = Real(1) / (m.a * m.d - m.b * m.c);
    return {m.d * scale, -m.b * scale, -m.c * scale, m.a * scale};
}

// Stress decay: the inverse rest shape after the stretch U = RᵀF has relaxed to
// I + (U − I)·keep (keep = exp(−Δt/τ); 0: viscous, 1: elastic). With edges E = F·D, D the rest
// shape, the new rest shape is U'⁻¹·U·D.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real> relaxedInverseShape(const Matrix2<Real>& inverseShape,
                                                               const Matrix2<Real>& F, Real keep) {
    const Real sum = F.a + F.d, skew = F.c - F.b;
    const Real s = std::sqrt(sum * sum + skew * skew) + Real(1e-12);
    const Real cosine = sum / s, sine = skew / s;
    const Matrix2<Real> U{cosine * F.a + sine * F.c, cosine * F.b + sine * F.d,
                          cosine * F.c - sine * F.a, cosine * F.d - sine * F.b};
    const Real determinant = U.a * U.d - U.b * U.c;
    if (!(determinant > Real(1e-6))) {
        return inverseShape; // turned inside out or flat: leave it to recover elastically
    }
    const Matrix2<Real> kept{Real(1) + (U.a - Real(1)) * keep, U.b * keep, U.c * keep,
                             Real(1) + (U.d - Real(1)) * keep};
    return inverseShape * (inverse(U) * kept);
}

} // namespace dipwright::pbd
