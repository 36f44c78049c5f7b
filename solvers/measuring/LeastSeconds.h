// Measures the shortest run time of some work. Used to find a device's highest performance.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace dipwright::numerics {

// Returns the run time of the fastest of several attempts, in seconds. Disturbances can only make
// the work slower.
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
