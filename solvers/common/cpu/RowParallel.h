// Distributes the rows of a grid over all cores in bands that do not depend on the number of
// threads.
#pragma once

#include "common/cpu/FlushDenormals.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
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

// Returns the sum of sumOfRow(row) over all rows, always added in the same order.
template <typename SumOfRow>
double sumOverRows(int rows, int columns, const SumOfRow& sumOfRow) {
    std::vector<double> sums(std::size_t(rows), 0.0);
    forRowBands(rows, columns, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            sums[std::size_t(row)] = sumOfRow(row);
        }
    });
    double sum = 0;
    for (const double rowSum : sums) {
        sum += rowSum;
    }
    return sum;
}

} // namespace dipwright::cpu
