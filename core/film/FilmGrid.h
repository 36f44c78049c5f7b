// The points of a floating film as its settings have them, and which of them barriers hold.
#pragma once

#include "settings/FilmSettings.h"

#include <cstdint>
#include <vector>

namespace dipwright {

// The floating film, evenly spaced: the printed sheet grown by the swell.
solver::FilmGrid filmGrid(const FilmSettings& settings);
// One byte a point of `grid`, empty when all edges are free.
std::vector<std::uint8_t> pinnedPoints(const FilmEdges& edges, const solver::FilmGrid& grid);

} // namespace dipwright
