#include "film/FilmLines.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Counts cells outside the fine part. At d mm from the fine part, the spacing is c + g·d, up to the
// coarsest cell. Here c is the finest cell, and g the logarithm of mostCellGrowth. The number of
// cells within d is the integral of 1 / spacing.
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
    double cell_; // size of the finest cells, mm
    double growth_ = std::log(mostCellGrowth);
    // Distance at which the coarsest cells begin, mm.
    double reach_ = cell_ * (coarsestCell - 1) / growth_;
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
    // Use whole cells, none larger than requested. Before refinement their number is even. Then a
    // film with half as many cells has every second line of this one.
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
