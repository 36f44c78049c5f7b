// Distributes the rows of a grid over the threads. What a row computes must not depend on its band.
#pragma once

#include "common/cpu/FlushDenormals.h"
#include "parallel/ParallelFor.h"
#include "parallel/Threads.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dipwright::cpu {

// A band with less is not worth a thread.
inline constexpr int leastPointsPerBand = 512, leastRowsPerBand = 8;

// Returns the number of bands of a grid: one for each thread of the team, or fewer.
inline int bandCount(int rows, int columns) {
    const int most = std::min(rows * columns / leastPointsPerBand, rows / leastRowsPerBand);
    return most > 1 ? std::min(loopThreads(), most) : 1;
}
inline int firstRowOfBand(int rows, int bands, int band) {
    return int(std::int64_t(rows) * band / bands);
}

// Calls work(begin, end) for each band of rows of a grid.
template <typename Work>
void forRowBands(int rows, int columns, const Work& work) {
    const int bands = bandCount(rows, columns);
    if (bands == 1) {
        work(0, rows);
        return;
    }
    parallelForEvenly(0, bands, [&](int band) {
        const FlushDenormals flush;
        work(firstRowOfBand(rows, bands, band), firstRowOfBand(rows, bands, band + 1));
    });
}

// Calls work(row) for each row of a grid.
template <typename Work>
void forRows(int rows, int columns, const Work& work) {
    forRowBands(rows, columns, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            work(row);
        }
    });
}

// Calls work(row) for the first row of each band but the first.
template <typename Work>
void forBandStarts(int rows, int columns, const Work& work) {
    const int bands = bandCount(rows, columns);
    const auto start = [&](int band) {
        const FlushDenormals flush;
        work(firstRowOfBand(rows, bands, band));
    };
    if (bands == 2) { // a few rows are not worth another meeting of the threads
        start(1);
    } else {
        parallelForEvenly(1, bands, start);
    }
}

// Calls work(stage, row) for each stage of each row. A stage of a row may use the stage before of
// the row and of its two neighbours. It may overwrite what only stages before the last one used. So
// a band's rows pass through all stages while they are in the cache. Rows at the ends of a band
// wait until the stage before is complete in all bands.
template <int stages, typename Work>
void forRowStages(int rows, int columns, const Work& work) {
    static_assert(2 * (stages - 1) <= leastRowsPerBand);
    forRowBands(rows, columns, [&](int begin, int end) {
        for (int front = begin; front < end + stages - 1; ++front) {
            for (int stage = 0; stage < stages; ++stage) {
                const int row = front - stage;
                const int first = begin > 0 ? begin + stage : begin;
                const int last = end < rows ? end - stage : end;
                if (row >= first && row < last) {
                    work(stage, row);
                }
            }
        }
    });
    forBandStarts(rows, columns, [&](int begin) {
        for (int stage = 1; stage < stages; ++stage) {
            for (int row = begin - stage; row < begin + stage; ++row) {
                work(stage, row);
            }
        }
    });
}

// Returns the sum of all sums. A Sum begins at zero and has a member add(other).
template <typename Sum>
Sum sumOf(const std::vector<Sum>& sums) {
    Sum sum;
    for (const Sum& each : sums) {
        sum.add(each);
    }
    return sum;
}

// Returns the sum of sumOfRow(row) over all rows.
template <typename Sum, typename SumOfRow>
Sum sumOverRows(int rows, int columns, const SumOfRow& sumOfRow) {
    std::vector<Sum> sums(static_cast<std::size_t>(rows));
    forRows(rows, columns, [&](int row) { sums[std::size_t(row)] = sumOfRow(row); });
    return sumOf(sums);
}

} // namespace dipwright::cpu
