#include "film/FilmSettings.h"

namespace dipwright {

solver::FilmGrid filmGrid(const FilmSettings& settings) {
    return {settings.columns, settings.rows, settings.width.value() * settings.swellX,
            settings.height.value() * settings.swellY};
}

std::vector<std::uint8_t> pinnedPoints(const FilmSettings& settings) {
    if (settings.edges == FilmEdges{}) {
        return {};
    }
    std::vector<std::uint8_t> pinned;
    pinned.reserve(filmGrid(settings).pointCount());
    for (int row = 0; row < settings.rows; ++row) {
        for (int column = 0; column < settings.columns; ++column) {
            const bool held = (settings.edges.leftPinned && column == 0) ||
                              (settings.edges.rightPinned && column == settings.columns - 1) ||
                              (settings.edges.topPinned && row == 0) ||
                              (settings.edges.bottomPinned && row == settings.rows - 1);
            pinned.push_back(held ? 1 : 0);
        }
    }
    return pinned;
}

} // namespace dipwright
