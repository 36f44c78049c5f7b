#include "sheet/page/InkDistance.h"

#include "parallel/ParallelFor.h"

#include <cmath>
#include <limits>

namespace dipwright {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();

// Replaces the marks of a column by each cell's squared distance to the nearest mark in the column.
void measureColumn(const std::vector<unsigned char>& marked, QSize grid, int column,
                   std::vector<float>& squares) {
    const auto at = [&](int row) {
        return std::size_t(row) * std::size_t(grid.width()) + std::size_t(column);
    };
    float distance = far;
    for (int row = 0; row < grid.height(); ++row) {
        distance = marked[at(row)] ? 0 : distance + 1;
        squares[at(row)] = distance * distance;
    }
    distance = far;
    for (int row = grid.height() - 1; row >= 0; --row) {
        distance = marked[at(row)] ? 0 : distance + 1;
        squares[at(row)] = std::min(squares[at(row)], distance * distance);
    }
}

// Turns squared distances along the columns into distances in the plane: the lower envelope of one
// parabola per cell of the row.
void measureRow(float* squares, int width) {
    std::vector<int> vertices;
    std::vector<double> begins; // where each parabola becomes the lowest
    for (int i = 0; i < width; ++i) {
        if (squares[i] == far) {
            continue;
        }
        double begin = -std::numeric_limits<double>::infinity();
        while (!vertices.empty()) {
            const int last = vertices.back();
            begin =
                (double(squares[i]) + double(i) * i - double(squares[last]) - double(last) * last) /
                (2.0 * (i - last));
            if (begin > begins.back()) {
                break;
            }
            vertices.pop_back();
            begins.pop_back();
            begin = -std::numeric_limits<double>::infinity();
        }
        vertices.push_back(i);
        begins.push_back(begin);
    }
    if (vertices.empty()) {
        return;
    }
    std::vector<float> measured(std::size_t(width), 0.0f);
    std::size_t lowest = 0;
    for (int i = 0; i < width; ++i) {
        while (lowest + 1 < vertices.size() && begins[lowest + 1] <= i) {
            ++lowest;
        }
        const double along = i - vertices[lowest];
        measured[std::size_t(i)] =
            float(std::sqrt(along * along + double(squares[vertices[lowest]])));
    }
    std::copy(measured.begin(), measured.end(), squares);
}

} // namespace

std::vector<float> distancesTo(const std::vector<unsigned char>& marked, QSize grid) {
    std::vector<float> distances(marked.size());
    parallelFor(0, grid.width(),
                [&](int column) { measureColumn(marked, grid, column, distances); });
    parallelFor(0, grid.height(), [&](int row) {
        measureRow(distances.data() + std::size_t(row) * std::size_t(grid.width()), grid.width());
    });
    return distances;
}

} // namespace dipwright
