// Distributes the rows of a grid over all cores in bands that do not depend on the number of
// threads.
#pragma once

#include "common/cpu/FlushDenormals.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace dipwright::cpu {

inline constexpr int pointsPerBand = 8192;

// Calls work(begin, end) for each band of rows of a grid.
template <typename Work>
void forRowBands(int rows, int columns, const Work& work) {
    const int rowsPerBand = std::max(pointsPerBand / columns, 8);
    if (rows <= rowsPerBand) { // a coarse grid is not worth a task
        work(0, rows);
        return;
    }
    const int bands = (rows + rowsPerBand - 1) / rowsPerBand;
    parallelForPieces(0, bands, 1, [&](int first, int last) {
        const FlushDenormals flush;
        for (int band = first; band < last; ++band) {
            work(band * rowsPerBand, std::min(rows, (band + 1) * rowsPerBand));
        }
    });
}

// Calls work(stage, row) for each stage of each row. A stage of a row may use the stage before of
// the row and of its two neighbours. It may overwrite what only stages before the last one used. So
// a band's rows pass through all stages while they are in the cache. Rows at the ends of a band
// wait until the stage before is complete in all bands.
template <int stages, typename Work>
void forRowStages(int rows, int columns, const Work& work) {
    const auto inner = [rows](int stage, int begin, int end) {
        const int first = begin > 0 ? std::min(begin + stage, end) : begin;
        return std::pair(first, end < rows ? std::max(end - stage, first) : end);
    };
    forRowBands(rows, columns, [&](int begin, int end) {
        for (int front = begin; front < end + stages - 1; ++front) {
            for (int stage = 0; stage < stages; ++stage) {
                const int row = front - stage;
                const auto [first, last] = inner(stage, begin, end);
                if (row >= first && row < last) {
                    work(stage, row);
                }
            }
        }
    });
    for (int stage = 1; stage < stages; ++stage) {
        forRowBands(rows, columns, [&](int begin, int end) {
            const auto [first, last] = inner(stage, begin, end);
            for (int row = begin; row < first; ++row) {
                work(stage, row);
            }
            for (int row = last; row < end; ++row) {
                work(stage, row);
            }
        });
    }
}

// Returns the sum of sumOfRow(row) over all rows. A Sum begins at zero and has a member add(other).
template <typename Sum, typename SumOfRow>
Sum sumOverRows(int rows, int columns, const SumOfRow& sumOfRow) {
    std::vector<Sum> sums(static_cast<std::size_t>(rows));
    forRowBands(rows, columns, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            sums[std::size_t(row)] = sumOfRow(row);
        }
    });
    Sum sum;
    for (const Sum& ofRow : sums) {
        sum.add(ofRow);
    }
    return sum;
}

} // namespace dipwright::cpu
