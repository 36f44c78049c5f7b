// The loops are compiled for each instruction set that Highway supports, and the best one is chosen
// at run time, as for the film.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measuring/cpu/CpuCeiling.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace dipwright::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr hn::ScalableTag<float> lanes;

// Multiplies and adds in enough independent chains to hide an operation's latency. Returns the
// number of floating point operations. Writing to `sink` keeps the compiler from removing them.
double multiplyAdd(int rounds, float* sink) {
    const auto factor = hn::Set(lanes, 0.999f), term = hn::Set(lanes, 0.001f);
    auto a = hn::Set(lanes, 1.0f), b = hn::Set(lanes, 1.1f), c = hn::Set(lanes, 1.2f),
         d = hn::Set(lanes, 1.3f), e = hn::Set(lanes, 1.4f), f = hn::Set(lanes, 1.5f),
         g = hn::Set(lanes, 1.6f), h = hn::Set(lanes, 1.7f), i = hn::Set(lanes, 1.8f),
         j = hn::Set(lanes, 1.9f);
    for (int round = 0; round < rounds; ++round) {
        a = hn::MulAdd(a, factor, term);
        b = hn::MulAdd(b, factor, term);
        c = hn::MulAdd(c, factor, term);
        d = hn::MulAdd(d, factor, term);
        e = hn::MulAdd(e, factor, term);
        f = hn::MulAdd(f, factor, term);
        g = hn::MulAdd(g, factor, term);
        h = hn::MulAdd(h, factor, term);
        i = hn::MulAdd(i, factor, term);
        j = hn::MulAdd(j, factor, term);
    }
    constexpr int chains = 10;
    const auto sum = hn::Add(
        hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, d)), hn::Add(hn::Add(e, f), hn::Add(g, h))),
        hn::Add(i, j));
    *sink = hn::GetLane(sum);
    return 2.0 * chains * double(hn::Lanes(lanes)) * rounds;
}

// Computes a = b + s·c over `count` floats; `count` is a multiple of the longest vector.
void triad(float* a, const float* b, const float* c, std::size_t count) {
    const auto factor = hn::Set(lanes, 3.0f);
    for (std::size_t k = 0; k < count; k += hn::Lanes(lanes)) {
        hn::StoreU(hn::MulAdd(factor, hn::LoadU(lanes, c + k), hn::LoadU(lanes, b + k)), lanes,
                   a + k);
    }
}

} // namespace

} // namespace dipwright::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "measuring/LeastSeconds.h"
#include "measuring/cpu/CpuCeiling.h"
#include "parallel/ParallelFor.h"
#include "parallel/Threads.h"

#include <vector>

namespace dipwright {

namespace {

HWY_EXPORT(multiplyAdd);
HWY_EXPORT(triad);

constexpr int rounds = 5'000'000;
constexpr std::size_t floatsAtOnce = std::size_t(1) << 20;
constexpr std::size_t pieces = 32; // 128 MiB per array

double measuredFlops() {
    const int threads = loopThreads();
    std::vector<double> flops(std::size_t(threads), 0.0);
    std::vector<float> sinks(std::size_t(threads), 0.0f);
    const double seconds = numerics::leastSeconds([&] {
        parallelForEvenly(std::size_t(0), flops.size(), [&](std::size_t thread) {
            flops[thread] = HWY_DYNAMIC_DISPATCH(multiplyAdd)(rounds, &sinks[thread]);
        });
    });
    double sum = 0;
    for (const double each : flops) {
        sum += each;
    }
    return sum / seconds;
}

double measuredBytes() {
    std::vector<float> a(pieces * floatsAtOnce), b(a.size(), 1.0f), c(a.size(), 2.0f);
    const double seconds = numerics::leastSeconds([&] {
        parallelFor(std::size_t(0), pieces, [&](std::size_t piece) {
            const std::size_t first = piece * floatsAtOnce;
            HWY_DYNAMIC_DISPATCH(triad)(&a[first], &b[first], &c[first], floatsAtOnce);
        });
    });
    return 3.0 * sizeof(float) * double(a.size()) / seconds;
}

} // namespace

solver::Ceiling cpuCeiling() {
    return {measuredFlops(), measuredBytes()};
}

} // namespace dipwright

#endif
