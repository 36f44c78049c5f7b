// Divides the paper's film into tiles, one for each thread block on the GPU.
#pragma once

#include <dipwright/FilmSolver.h>

#include <optional>

namespace dipwright::cuda {

// A division into tiles. A tile owns its points, and recomputes all points within `reach` of them.
// So it exchanges halos only once in `reach` sweeps. A warp works on a strip of some rows of all
// these points, with one column per lane.
struct PaperTiles {
    static constexpr int lanes = 32;
    // Per block; with this number, each thread has 72 registers.
    static constexpr int mostWarps = 28;

    int across = 1, down = 1; // number of tiles along X and Z
    int reach = 0;            // width of the halo; also the number of sweeps in one pass
    int stripRows = 1;
    int warps = 0; // per block

    constexpr int count() const { return across * down; }
};

// Divides the film into tiles of strips with `stripRows` rows. Returns the division with the most
// tiles up to `maximumTiles`, or nothing if the film needs more tiles.
std::optional<PaperTiles> paperTiles(const solver::FilmGrid& film, int iterations, int stripRows,
                                     int maximumTiles);

} // namespace dipwright::cuda
