// Divides the paper's film into tiles, one for each thread block on the GPU.
#pragma once

#include <dipwright/FilmSolver.h>

#include <optional>

namespace dipwright::cuda {

// A tile owns its points. It also recomputes the points within `reach` of them, so that it
// exchanges halos only after that many sweeps. A warp works on a strip of some rows of all these
// points, with one column per lane.
struct PaperTiles {
    static constexpr int lanes = 32;
    static constexpr int mostWarps = 28; // per block; leaves each thread 72 registers

    int across = 1, down = 1; // number of tiles
    int reach = 0;            // width of the halo; also the sweeps of one pass
    int stripRows = 1;
    int warps = 0; // per block

    constexpr int count() const { return across * down; }
};

// Returns the division into strips of `stripRows` with the most tiles up to `maximumTiles`. Returns
// nothing if the film needs more tiles.
std::optional<PaperTiles> paperTiles(const solver::FilmGrid& film, int iterations, int stripRows,
                                     int maximumTiles);

} // namespace dipwright::cuda
