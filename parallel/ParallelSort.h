// Sorting on all cores.
#pragma once

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cstddef>

namespace dipwright {

// Sorts [begin, end) by <. The order of equal elements is unspecified, but the same in every run
// and for any number of threads.
template <typename RandomAccessIterator>
void parallelSort(RandomAccessIterator begin, RandomAccessIterator end) {
    constexpr std::ptrdiff_t sortedAtOnce = 8192;
    const std::ptrdiff_t size = end - begin;
    const auto at = [&](std::ptrdiff_t index) { return begin + std::min(index, size); };
    const auto runs = [&](std::ptrdiff_t length) { return (size + length - 1) / length; };
    parallelFor(std::ptrdiff_t(0), runs(sortedAtOnce), [&](std::ptrdiff_t run) {
        std::sort(at(run * sortedAtOnce), at((run + 1) * sortedAtOnce));
    });
    for (std::ptrdiff_t length = sortedAtOnce; length < size; length *= 2) {
        parallelFor(std::ptrdiff_t(0), runs(2 * length), [&](std::ptrdiff_t pair) {
            const std::ptrdiff_t first = 2 * pair * length;
            std::inplace_merge(at(first), at(first + length), at(first + 2 * length));
        });
    }
}

} // namespace dipwright
