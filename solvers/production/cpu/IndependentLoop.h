// DIPWRIGHT_INDEPENDENT_LOOP tells the compiler that the next loop's iterations are independent and
// can be vectorised.
#pragma once

#include "common/HostDevice.h"

#include <cstddef>

#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" // sanitizer builds do not vectorise
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#elif defined(_MSC_VER)
#define DIPWRIGHT_INDEPENDENT_LOOP __pragma(loop(ivdep))
#else
#define DIPWRIGHT_INDEPENDENT_LOOP
#endif

namespace dipwright::cpu {

// Calls work(first, last) for ranges that cover [0, count). If `count` is at least 16, the length
// of each range is a multiple of 16, so that a vectorised loop never runs one index at a time.
// Ranges may overlap, so `work` must not change its own input.
template <typename Work>
DIPWRIGHT_IN_LOOP void inWholeVectors(std::size_t count, const Work& work) {
    constexpr std::size_t widest = 16;
    const std::size_t whole = count < widest ? count : count / widest * widest;
    work(std::size_t(0), whole);
    if (whole < count) {
        work(count - widest, count);
    }
}

} // namespace dipwright::cpu
