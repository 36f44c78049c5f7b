// Sums over the film that have the same bits on all devices, however the terms are divided over
// threads. Each term is rounded to a multiple of a power of two, and the multiples are added as
// integers, in any order (Demmel and Nguyen, Parallel Reproducible Summation, 2015).
#pragma once

#include "common/HostDevice.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace dipwright::numerics {

// Added to a number below 2^51·unit, this number pushes all digits below `unit` out of the sum. The
// lowest bits of the sum are then the multiple of `unit` that is nearest to the number.
constexpr double roundingShift(double unit) {
    return 0x1.8p52 * unit;
}

DIPWRIGHT_HOST_DEVICE inline std::int64_t bitsOf(double value) {
    std::int64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

// A sum of the products of two vectors' entries. One vector has the length 1, and the other is its
// image under the preconditioned stiffness, so a term is hardly ever above 10. From 2^16 on, the
// sum is wrong, but the same on all devices.
struct ProductSum {
    static constexpr double unit = 0x1p-35;
    static constexpr double shift = roundingShift(unit);

    // Returns the term as a multiple of `unit`.
    DIPWRIGHT_HOST_DEVICE static std::int64_t multiple(double term) {
        return bitsOf(term + shift) - bitsOf(shift);
    }
    DIPWRIGHT_HOST_DEVICE static double value(std::int64_t multiples) {
        return double(multiples) * unit;
    }
};

// A sum of squares: the sum of the nearest whole numbers, and of what is left of each term, in
// multiples of `unit`. So squares of very different sizes are summed precisely. The sum is not a
// number if a term is not, or if the sum reaches `limit`.
struct SquareSum {
    static constexpr double unit = 0x1p-51, limit = 0x1p40;
    static constexpr double shift = roundingShift(unit), wholeShift = roundingShift(1);

    std::int64_t whole = 0, rest = 0;

    DIPWRIGHT_HOST_DEVICE void add(double square) {
        const double term = square < limit ? square : limit;
        const double shifted = term + wholeShift;
        whole += bitsOf(shifted) - bitsOf(wholeShift);
        rest += bitsOf((term - (shifted - wholeShift)) + shift) - bitsOf(shift);
    }
    DIPWRIGHT_HOST_DEVICE void add(const SquareSum& other) {
        whole += other.whole;
        rest += other.rest;
    }
    DIPWRIGHT_HOST_DEVICE double root() const {
        const double sum = double(whole) + double(rest) * unit;
        return sum < limit ? std::sqrt(sum) : std::numeric_limits<double>::quiet_NaN();
    }
};

} // namespace dipwright::numerics
