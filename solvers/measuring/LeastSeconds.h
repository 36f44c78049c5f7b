// How long work takes at the least, to measure what a device can do at most.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace dipwright::numerics {

// The seconds of the fastest of some attempts: nothing makes a ceiling higher.
template <typename Work>
double leastSeconds(const Work& work) {
    constexpr int attempts = 4;
    double least = std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const auto end = std::chrono::steady_clock::now();
        least = std::min(least, std::chrono::duration<double>(end - start).count());
    }
    return least;
}

} // namespace dipwright::numerics
