// Cutting a row of points into tiles.
#pragma once

namespace dipwright::cuda {

// First column (or row) of tile `index` of `count` over `points`; the end of the one before it.
constexpr int tileStart(int points, int count, int index) {
    return int(static_cast<long long>(points) * index / count);
}

} // namespace dipwright::cuda
