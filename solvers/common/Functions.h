// Functions whose results have the same bits on all devices. They use only operations that IEEE 754
// rounds exactly; the libraries of two devices differ in the last bit.
#pragma once

#include "common/HostDevice.h"

#include <cmath>

namespace dipwright::numerics {

// Returns eˣ for x ≤ 0; the relative error is below 1e-15; 0 below −700.
DIPWRIGHT_HOST_DEVICE inline double decay(double x) {
    constexpr double least = -700; // e⁻⁷⁰⁰ is near the smallest number
    if (!(x > least)) {
        return x == x ? 0 : x;
    }
    // x = n·ln 2 + rest; ln 2 in two parts, so that the product with n has no rounding error.
    constexpr double log2 = 0x1.62e42fefa3800p-1, log2Rest = 0x1.ef35793c76730p-45;
    const int n = int(x / log2 - 0.5);
    const double rest = (x - n * log2) - n * log2Rest;
    double sum = 1;
    for (int k = 14; k > 0; --k) {
        sum = 1 + sum * (rest * (1.0 / k));
    }
    return std::ldexp(sum, n);
}

// Returns the sine of an angle from 0 to π/2; the error is below 1e-15.
DIPWRIGHT_HOST_DEVICE inline double sineOf(double angle) {
    const double square = angle * angle;
    double sum = 1;
    for (int k = 22; k > 0; k -= 2) {
        sum = 1 - sum * (square * (1.0 / (k * (k + 1))));
    }
    return angle * sum;
}

// Returns the angle from 0 to π/2 that has this cosine; the error is below 2e-15.
DIPWRIGHT_HOST_DEVICE inline double angleOf(double cosine) {
    // The tangent of half the angle, and then of a sixteenth of it.
    double tangent = std::sqrt((1 - cosine) / (1 + cosine));
    for (int halving = 0; halving < 3; ++halving) {
        tangent = tangent / (1 + std::sqrt(1 + tangent * tangent));
    }
    const double square = tangent * tangent;
    double sum = 0;
    for (int k = 17; k > 0; k -= 2) {
        sum = 1.0 / k - sum * square;
    }
    return 16 * tangent * sum;
}

} // namespace dipwright::numerics
