// The grid of a floating film according to its settings, and the points that barriers hold.
#pragma once

#include "settings/FilmSettings.h"

#include <cstdint>
#include <vector>

namespace dipwright {

// Returns the evenly spaced grid of the floating film: the printed sheet enlarged by the swell.
solver::FilmGrid filmGrid(const FilmSettings& settings);
// Returns one byte for each point of `grid`, non-zero if it is pinned; empty when all edges are
// free.
std::vector<std::uint8_t> pinnedPoints(const FilmEdges& edges, const solver::FilmGrid& grid);

} // namespace dipwright
