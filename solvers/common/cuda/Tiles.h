// Divides a row of points into tiles.
#pragma once

namespace dipwright::cuda {

// Returns the first column (or row) of tile `index` of `count` over `points`. This is also the end
// of the previous tile.
constexpr int tileStart(int points, int count, int index) {
    return int(static_cast<long long>(points) * index / count);
}

} // namespace dipwright::cuda
