#include "film/FilmGrid.h"

#include <cmath>

namespace dipwright {

solver::FilmGrid filmGrid(const FilmSettings& settings) {
    const auto points = [&](int count) {
        return int(std::lround((count - 1) * settings.refinement)) + 1;
    };
    return {points(settings.columns), points(settings.rows),
            settings.width.value() * settings.swellX, settings.height.value() * settings.swellY};
}

std::vector<std::uint8_t> pinnedPoints(const FilmEdges& edges, const solver::FilmGrid& grid) {
    if (edges == FilmEdges{}) {
        return {};
    }
    std::vector<std::uint8_t> pinned;
    pinned.reserve(grid.pointCount());
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const bool held = (edges.leftPinned && column == 0) ||
                              (edges.rightPinned && column == grid.columns - 1) ||
                              (edges.topPinned && row == 0) ||
                              (edges.bottomPinned && row == grid.rows - 1);
            pinned.push_back(held ? 1 : 0);
        }
    }
    return pinned;
}

} // namespace dipwright
