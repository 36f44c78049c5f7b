#include "production/cpu/RowMath.h"

#include "common/cpu/SimdClones.h"

namespace dipwright::cpu {

DIPWRIGHT_SIMD_CLONES
double rowDot(const float* a, const float* b, std::size_t count) {
    constexpr std::size_t lanes = 16;
    float sums[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sums[lane] += a[i + lane] * b[i + lane];
        }
    }
    double sum = 0;
    for (const float lane : sums) {
        sum += double(lane);
    }
    for (; i < count; ++i) {
        sum += double(a[i]) * double(b[i]);
    }
    return sum;
}

DIPWRIGHT_SIMD_CLONES
double rowWeightedSquares(const float* weight, const float* a, std::size_t count) {
    constexpr std::size_t lanes = 16;
    float sums[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sums[lane] += weight[i + lane] * a[i + lane] * a[i + lane];
        }
    }
    double sum = 0;
    for (const float lane : sums) {
        sum += double(lane);
    }
    for (; i < count; ++i) {
        sum += double(weight[i]) * double(a[i]) * double(a[i]);
    }
    return sum;
}

} // namespace dipwright::cpu
