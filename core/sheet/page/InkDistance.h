// How far places of a grid are from those that are marked.
#pragma once

#include <QSize>
#include <vector>

namespace dipwright {

// Of each place, row by row, to the nearest that is marked (not 0), between their middles, in
// places; infinity where none is. Exact (Felzenszwalb and Huttenlocher, Distance Transforms of
// Sampled Functions, 2012). All cores.
std::vector<float> distancesTo(const std::vector<unsigned char>& marked, QSize grid);

} // namespace dipwright
