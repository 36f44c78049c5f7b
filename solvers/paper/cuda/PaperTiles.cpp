#include "paper/cuda/PaperTiles.h"

#include <algorithm>

namespace dipwright::cuda {

namespace {

constexpr int mostSweepsPerPass = 8; // more sweeps would recompute too many points

int roundedUp(int value, int divisor) {
    return (value + divisor - 1) / divisor;
}

} // namespace

std::optional<PaperTiles> paperTiles(const solver::FilmGrid& film, int iterations, int stripRows,
                                     int maximumTiles) {
    PaperTiles tiles;
    tiles.reach = std::min(iterations, mostSweepsPerPass);
    tiles.stripRows = stripRows;
    tiles.across = roundedUp(film.columns, PaperTiles::lanes - 2 * tiles.reach);
    // A tile's halo reaches only into the adjacent tiles.
    tiles.down = std::clamp(maximumTiles / tiles.across, 1, std::max(1, film.rows / tiles.reach));
    tiles.warps = roundedUp(roundedUp(film.rows, tiles.down) + 2 * tiles.reach, stripRows);
    if (tiles.count() > maximumTiles || tiles.warps > PaperTiles::mostWarps) {
        return std::nullopt;
    }
    return tiles;
}

} // namespace dipwright::cuda
