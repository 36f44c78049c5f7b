// Divides a row of points into tiles.
#pragma once

namespace dipwright::cuda {

// Divides `points` columns (or rows) into `count` tiles and returns the first column of tile
// `index`. The previous tile ends there.
constexpr int tileStart(int points, int count, int index) {
    return int(static_cast<long long>(points) * index / count);
}

} // namespace dipwright::cuda
