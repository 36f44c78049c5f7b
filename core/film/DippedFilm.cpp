#include "film/DippedFilm.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {

bool DippedFilm::adheresAnywhere() const {
    return std::find(states.begin(), states.end(), solver::PointState::Adhered) != states.end();
}

Eigen::Vector2f restPosition(const solver::FilmGrid& grid, std::size_t point) {
    const auto columns = std::size_t(grid.columns);
    return {float(grid.restX(int(point % columns))), float(grid.restZ(int(point / columns)))};
}

std::vector<FilmTriangle> filmTriangles(const solver::FilmGrid& grid) {
    std::vector<FilmTriangle> triangles;
    triangles.reserve(2 * std::size_t(grid.columns - 1) * std::size_t(grid.rows - 1));
    const auto columns = std::uint32_t(grid.columns);
    for (std::uint32_t row = 0; row + 1 < std::uint32_t(grid.rows); ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t upperLeft = row * columns + column;
            const std::uint32_t upperRight = upperLeft + 1;
            const std::uint32_t lowerLeft = upperLeft + columns;
            const std::uint32_t lowerRight = lowerLeft + 1;
            if ((column + row) % 2 == 0) {
                triangles.push_back({upperLeft, lowerLeft, lowerRight});
                triangles.push_back({upperLeft, lowerRight, upperRight});
            } else {
                triangles.push_back({upperLeft, lowerLeft, upperRight});
                triangles.push_back({upperRight, lowerLeft, lowerRight});
            }
        }
    }
    return triangles;
}

namespace {

struct Cell {
    int column = 0, row = 0;
};

Cell cellOf(const solver::FilmGrid& grid, std::size_t triangle) {
    const std::size_t cell = triangle / 2, columns = std::size_t(grid.columns) - 1;
    return {int(cell % columns), int(cell / columns)};
}

double lineAt(const std::vector<double>& places, int count, double length, double share) {
    if (places.empty()) {
        return share * (count - 1);
    }
    const double place = (share - 0.5) * length;
    const auto next = std::upper_bound(places.begin() + 1, places.end() - 1, place);
    const double before = *(next - 1);
    return double(next - 1 - places.begin()) + (place - before) / (*next - before);
}

} // namespace

double restArea(const solver::FilmGrid& grid, std::size_t triangle) {
    const Cell cell = cellOf(grid, triangle);
    return grid.spacingX(cell.column) * grid.spacingZ(cell.row) / 2;
}

float cellOfTriangle(const solver::FilmGrid& grid, std::size_t triangle) {
    const Cell cell = cellOf(grid, triangle);
    return float(std::max(grid.spacingX(cell.column), grid.spacingZ(cell.row)));
}

float cellOfPoint(const solver::FilmGrid& grid, std::size_t point) {
    const int column = int(point % std::size_t(grid.columns));
    const int row = int(point / std::size_t(grid.columns));
    return float(std::max(
        {grid.spacingX(std::max(column - 1, 0)), grid.spacingX(std::min(column, grid.columns - 2)),
         grid.spacingZ(std::max(row - 1, 0)), grid.spacingZ(std::min(row, grid.rows - 2))}));
}

double columnAt(const solver::FilmGrid& grid, double share) {
    return lineAt(grid.columnPlaces, grid.columns, grid.width, share);
}

double rowAt(const solver::FilmGrid& grid, double share) {
    return lineAt(grid.rowPlaces, grid.rows, grid.depth, share);
}

std::size_t triangleAt(const solver::FilmGrid& grid, double column, double row) {
    const int i = std::clamp(int(column), 0, grid.columns - 2);
    const int j = std::clamp(int(row), 0, grid.rows - 2);
    const double x = column - i;
    const double y = row - j;
    // filmTriangles() divides the cells this way; the first triangle is the left one.
    const bool isFirst = (i + j) % 2 == 0 ? y >= x : x + y <= 1;
    return 2 * (std::size_t(j) * std::size_t(grid.columns - 1) + std::size_t(i)) +
           (isFirst ? 0 : 1);
}

std::size_t constraintCount(const solver::FilmGrid& grid, bool isotropic) {
    const auto columns = std::size_t(grid.columns);
    const auto rows = std::size_t(grid.rows);
    const std::size_t diagonals = isotropic ? 2 * (columns - 1) * (rows - 1) : 0;
    return columns * (rows - 1) + rows * (columns - 1) + diagonals;
}

PrincipalStretch principalStretch(const solver::FilmGrid& grid, const FilmTriangle& triangle,
                                  const std::array<Eigen::Vector3f, 3>& places) {
    Eigen::Matrix2d flat;
    Eigen::Matrix<double, 3, 2> dipped;
    for (int edge = 0; edge < 2; ++edge) {
        const auto corner = std::size_t(edge) + 1;
        flat.col(edge) =
            (restPosition(grid, triangle[corner]) - restPosition(grid, triangle[0])).cast<double>();
        dipped.col(edge) = (places[corner] - places[0]).cast<double>();
    }
    const Eigen::Matrix<double, 3, 2> gradient = dipped * flat.inverse();
    const Eigen::Matrix2d squared = gradient.transpose() * gradient;
    const double middle = squared.trace() / 2;
    const double radius = std::hypot((squared(0, 0) - squared(1, 1)) / 2, squared(0, 1));
    return {float(std::sqrt(middle + radius)), float(std::sqrt(std::max(0.0, middle - radius)))};
}

std::vector<PrincipalStretch> principalStretches(const DippedFilm& film) {
    std::vector<PrincipalStretch> stretches;
    for (const FilmTriangle& triangle : filmTriangles(film.grid)) {
        stretches.push_back(
            principalStretch(film.grid, triangle,
                             {film.positions[triangle[0]], film.positions[triangle[1]],
                              film.positions[triangle[2]]}));
    }
    return stretches;
}

float compression(const DippedFilm& film, const FilmTriangle& triangle,
                  const PrincipalStretch& stretch) {
    if (film.grown.empty()) {
        return stretch.smaller;
    }
    float grown = 0;
    for (const std::uint32_t point : triangle) {
        grown += film.grown[point] / 3;
    }
    return stretch.smaller / grown;
}

std::vector<float> constraintStretches(const DippedFilm& film) {
    const auto columns = std::size_t(film.grid.columns);
    const auto rows = std::size_t(film.grid.rows);
    std::vector<float> stretches;
    stretches.reserve(constraintCount(film.grid, false));
    const auto add = [&](std::size_t one, std::size_t other, double restLength) {
        const double length = (film.positions[one] - film.positions[other]).cast<double>().norm();
        stretches.push_back(float(length / restLength));
    };
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column + 1 < columns; ++column) {
            add(row * columns + column, row * columns + column + 1,
                film.grid.spacingX(int(column)));
        }
    }
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            add(row * columns + column, (row + 1) * columns + column, film.grid.spacingZ(int(row)));
        }
    }
    return stretches;
}

std::vector<float> pointStretches(const DippedFilm& film) {
    const auto columns = std::size_t(film.grid.columns);
    const auto rows = std::size_t(film.grid.rows);
    const std::vector<float> constraints = constraintStretches(film);
    const std::size_t firstVertical = rows * (columns - 1);
    std::vector<float> means;
    means.reserve(film.grid.pointCount());
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            float sum = 0;
            int count = 0;
            const auto add = [&](bool exists, std::size_t constraint) {
                if (exists) {
                    sum += constraints[constraint];
                    ++count;
                }
            };
            const std::size_t right = row * (columns - 1) + column;
            const std::size_t below = firstVertical + row * columns + column;
            add(column > 0, right - 1);
            add(column + 1 < columns, right);
            add(row > 0, below - columns);
            add(row + 1 < rows, below);
            means.push_back(sum / float(count));
        }
    }
    return means;
}

Distribution distribution(std::vector<float> values) {
    if (values.empty()) {
        return {};
    }
    std::sort(values.begin(), values.end());
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    const auto rank = std::size_t(std::ceil(0.95 * double(values.size())));
    return {values.front(), sum / double(values.size()), values[rank - 1], values.back()};
}

} // namespace dipwright
