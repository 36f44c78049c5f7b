// Divides a row of points into tiles.
#pragma once

namespace dipwright::cuda {

// Divides `points` columns (or rows) into `count` tiles and returns the first column of tile
// `index`. The previous tile ends there.
constexpr int tileStart(int points, int count, int index) {
    return int(unsigned(points) * unsigned(index) / unsigned(count)); // the product is below 2³²
}

} // namespace dipwright::cuda
