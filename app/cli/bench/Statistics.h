// Computes median, minimum and maximum of repeated measurements.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace dipwright::cli {

struct Statistics {
    double median = 0, minimum = 0, maximum = 0;
};

// Returns the statistics of `values`, which must not be empty.
inline Statistics statistics(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    return {median, values.front(), values.back()};
}

template <typename Work>
double secondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Runs `work` `runs` times. Returns the statistics of the seconds that it took.
template <typename Work>
Statistics timed(int runs, const Work& work) {
    std::vector<double> seconds;
    seconds.reserve(std::size_t(runs));
    for (int run = 0; run < runs; ++run) {
        seconds.push_back(secondsOf(work));
    }
    return statistics(std::move(seconds));
}

} // namespace dipwright::cli
