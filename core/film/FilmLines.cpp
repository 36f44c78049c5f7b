#include "film/FilmLines.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Cells beyond the fine part. The spacing at a distance of d mm from it is c + g·d, g the logarithm
// of the growth, up to the coarsest; the cells up to there are the integral of its inverse.
class CoarseningCells {
public:
    explicit CoarseningCells(double cell) : cell_(cell) {}

    double countTo(double distance) const {
        return distance <= reach_ ? std::log1p(growth_ * distance / cell_) / growth_
                                  : cellsInReach_ + (distance - reach_) / (coarsestCell * cell_);
    }
    double distanceTo(double count) const {
        return count <= cellsInReach_ ? cell_ * std::expm1(growth_ * count) / growth_
                                      : reach_ + (count - cellsInReach_) * coarsestCell * cell_;
    }

private:
    double cell_; // mm, the finest
    double growth_ = std::log(mostCellGrowth);
    double reach_ = cell_ * (coarsestCell - 1) / growth_; // mm, where they are coarsest
    double cellsInReach_ = std::log(coarsestCell) / growth_;
};

} // namespace

std::vector<double> gradedLines(double length, double from, double to, double cell,
                                double refinement, int fewest) {
    const double half = length / 2;
    from = std::clamp(from, -half, half);
    to = std::clamp(to, from, half);
    const CoarseningCells beyond(cell);
    const double before = beyond.countTo(from + half);
    const double fine = (to - from) / cell;
    const double all = before + fine + beyond.countTo(half - to);
    // Whole cells, none larger than asked for. An even number of them before the refinement, so
    // that a film of half as many has every second line of this one.
    const double whole = 2 * std::ceil(all / 2 * (1 - 1e-12));
    const int count = std::max(int(std::lround(refinement * whole)), fewest - 1);
    std::vector<double> lines;
    lines.reserve(std::size_t(count) + 1);
    for (int line = 0; line <= count; ++line) {
        const double cells = all * line / count;
        const double place = cells < before ? from - beyond.distanceTo(before - cells)
                             : cells <= before + fine
                                 ? from + (cells - before) * cell
                                 : to + beyond.distanceTo(cells - before - fine);
        lines.push_back(place);
    }
    lines.front() = -half;
    lines.back() = half;
    return lines;
}

} // namespace dipwright
