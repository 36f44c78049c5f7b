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
// image under the preconditioned stiffness, so a term is hardly ever above 10. A term of 2^16 or
// more, or one that is not a number, counts as 0. The image's length (SquareSum) is then wrong too.
struct ProductSum {
    static constexpr double unit = 0x1p-35, limit = 0x1p16;
    static constexpr double shift = roundingShift(unit);

    // Returns the term as a multiple of `unit`.
    DIPWRIGHT_HOST_DEVICE static std::int64_t multiple(double term) {
        const bool counts = term > -limit && term < limit;
        return bitsOf((counts ? term : 0) + shift) - bitsOf(shift);
    }
    DIPWRIGHT_HOST_DEVICE static double value(std::int64_t multiples) {
        return double(multiples) * unit;
    }
};

// A sum of squares. Each square is split into a multiple of 2^-10 and a rest. Both are summed as
// integers. So squares of very different sizes are summed precisely. The sum is not a number if a
// term is not, or if the sum reaches `limit`.
struct SquareSum {
    static constexpr double coarseUnit = 0x1p-10, unit = 0x1p-51, limit = 0x1p30;
    static constexpr double coarseShift = roundingShift(coarseUnit), shift = roundingShift(unit);
    // No sum of at most this many terms overflows. The largest film (maximumFilmGrid in
    // FilmSettings.h) has two terms for each cell.
    static constexpr double mostTerms = 8'000'000;
    static_assert(limit / coarseUnit * mostTerms < 0x1p63);
    static_assert(coarseUnit / 2 / unit * mostTerms < 0x1p63);

    std::int64_t coarse = 0; // in multiples of `coarseUnit`
    std::int64_t rest = 0;   // in multiples of `unit`

    DIPWRIGHT_HOST_DEVICE void add(double square) {
        const double term = square < limit ? square : limit;
        const double shifted = term + coarseShift;
        coarse += bitsOf(shifted) - bitsOf(coarseShift);
        rest += bitsOf((term - (shifted - coarseShift)) + shift) - bitsOf(shift);
    }
    DIPWRIGHT_HOST_DEVICE void add(const SquareSum& other) {
        coarse += other.coarse;
        rest += other.rest;
    }
    DIPWRIGHT_HOST_DEVICE double root() const {
        const double sum = double(coarse) * coarseUnit + double(rest) * unit;
        return sum < limit ? std::sqrt(sum) : std::numeric_limits<double>::quiet_NaN();
    }
};

} // namespace dipwright::numerics
