// Interpolates values over the flat film, for drawing maps.
#pragma once

#include "dip/FilmMarks.h"
#include "dip/LaidFilm.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

// One value for each film point (NaN if unknown). Also stores which film is on the body, and the
// marks of this film.
class FilmValues {
public:
    FilmValues(const LaidFilm& laid, std::vector<float> values)
        : grid_(laid.film().grid), values_(std::move(values)), painted_(laid.contact().painted),
          isOn_(laid.painted().points) {}

    // Returns the value at a place given in cells, columns to the right and rows down.
    double at(double column, double row) const {
        const int i = std::clamp(int(column), 0, grid_.columns - 2);
        const int j = std::clamp(int(row), 0, grid_.rows - 2);
        const double x = column - i;
        const double y = row - j;
        const float* upper = values_.data() + std::size_t(j) * std::size_t(grid_.columns) + i;
        const float* lower = upper + grid_.columns;
        return (1 - y) * ((1 - x) * upper[0] + x * upper[1]) +
               y * ((1 - x) * lower[0] + x * lower[1]);
    }

    bool isPainted(double column, double row) const { return painted_[triangle(column, row)] != 0; }

    // Returns the most serious mark of painted film. Returns nothing if showMarks() has not been
    // called.
    std::optional<solver::PointMark> mark(double column, double row) const {
        return marks_.empty() ? std::nullopt : mostSeriousMark(marks_[triangle(column, row)]);
    }
    // Shows the marks of painted film and returns their solver::PointMark bits.
    std::uint8_t showMarks(const LaidFilm& laid) {
        std::uint8_t shown = 0;
        marks_.assign(painted_.size(), 0);
        for (std::uint32_t triangle = 0; triangle < painted_.size(); ++triangle) {
            marks_[triangle] = painted_[triangle] ? laid.marks(triangle) : std::uint8_t(0);
            shown |= marks_[triangle];
        }
        return shown;
    }

    // Returns the known values on painted film, or on the whole film if nothing is painted.
    std::vector<float> paintedValues() const {
        std::vector<float> painted, all;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (!std::isnan(values_[i])) {
                all.push_back(values_[i]);
                if (isOn_[i]) {
                    painted.push_back(values_[i]);
                }
            }
        }
        return !painted.empty() ? painted : !all.empty() ? all : std::vector<float>{0};
    }

private:
    std::size_t triangle(double column, double row) const { return triangleAt(grid_, column, row); }

    solver::FilmGrid grid_;
    std::vector<float> values_;
    std::vector<std::uint8_t> painted_; // for each film triangle: whether it is painted
    std::vector<std::uint8_t> marks_;   // for each film triangle: its mark bits; empty: not shown
    std::vector<std::uint8_t> isOn_;    // for each film point: whether it is on the body
};

} // namespace dipwright
