// Computes the distance from each cell of a grid to the nearest marked cell.
#pragma once

#include <QSize>
#include <vector>

namespace dipwright {

// Returns, row by row, each cell's distance to the nearest cell that is marked (not 0). Distances
// are between the cells' middles, in cells; infinity if no cell is marked. Exact (Felzenszwalb and
// Huttenlocher, Distance Transforms of Sampled Functions, 2012). Uses all cores.
std::vector<float> distancesTo(const std::vector<unsigned char>& marked, QSize grid);

} // namespace dipwright
