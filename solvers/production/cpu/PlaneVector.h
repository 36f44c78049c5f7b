// Two numbers per film point, x and z, in separate arrays for vector arithmetic.
#pragma once

#include "common/cpu/AlignedVector.h"

#include <cstddef>

namespace dipwright::cpu {

struct PlaneVector {
    using Real = float;
    AlignedVector<Real> x, z;

    PlaneVector() = default;
    explicit PlaneVector(std::size_t points) : x(points), z(points) {}
    std::size_t size() const { return x.size(); }
};

} // namespace dipwright::cpu
