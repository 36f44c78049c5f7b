// How the paper's film is cut into tiles, one for each block of threads on the GPU.
#pragma once

#include <dipwright/FilmSolver.h>

#include <optional>

namespace dipwright::cuda {

// A tile owns its points, and computes those within `reach` of them once more by itself, so that
// it exchanges halos only after that many sweeps. A warp works on a strip of some rows of all
// these points, one column a lane.
struct PaperTiles {
    static constexpr int lanes = 32;
    static constexpr int mostWarps = 28; // of one block: leaves each thread 72 registers

    int across = 1, down = 1; // tiles
    int reach = 0;            // columns and rows round a tile; the sweeps of one pass
    int stripRows = 1;
    int warps = 0; // of one block

    constexpr int count() const { return across * down; }
};

// The cut into strips of `stripRows` with the most tiles up to `maximumTiles`, or nothing when the
// film needs more than these.
std::optional<PaperTiles> paperTiles(const solver::FilmGrid& film, int iterations, int stripRows,
                                     int maximumTiles);

} // namespace dipwright::cuda
