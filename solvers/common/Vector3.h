// A vector of three numbers, for formulas that run on the host and on a GPU.
#pragma once

#include "common/HostDevice.h"

#include <cmath>

namespace dipwright::numerics {

template <typename Real>
struct Vector3 {
    Real x{}, y{}, z{};
};

template <typename Real>
DIPWRIGHT_HOST_DEVICE constexpr Vector3<Real> operator+(Vector3<Real> a, Vector3<Real> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Real>
DIPWRIGHT_HOST_DEVICE constexpr Vector3<Real> operator-(Vector3<Real> a, Vector3<Real> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Real>
DIPWRIGHT_HOST_DEVICE constexpr Vector3<Real> operator*(Vector3<Real> a, Real factor) {
    return {a.x * factor, a.y * factor, a.z * factor};
}
template <typename Real>
DIPWRIGHT_HOST_DEVICE constexpr Real dot(Vector3<Real> a, Vector3<Real> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real length(Vector3<Real> a) {
    return std::sqrt(dot(a, a));
}

} // namespace dipwright::numerics
