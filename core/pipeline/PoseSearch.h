// Which way round to dip: candidate poses are tried on a coarse film and ranked by what they paint.
#pragma once

#include "project/Project.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

struct PoseSearchOptions {
    int immersions = 1;  // 1 or 2
    int candidates = 48; // poses tried, each by one coarse dip
};

// One immersion or a pair, as found.
struct RankedPoses {
    std::vector<Immersion> immersions;
    double coverage = 0; // share of the surface painted, 0 … 1
    // The same, each place counted by how little the film is drawn out or pushed together there (of
    // a pair: the better of the two). Ranked by this.
    double quality = 0;
};

// How well film that is stretched by λ1 ≥ λ2 shows its picture: 1 up to λ1 = 1.2 and down to
// λ2 = 0.7, falling to 0 at 2.5 and at 0.2.
double printQuality(double larger, double smaller);

// The candidates: the six sides of the bounding box and directions spread evenly over the sphere,
// each the side that goes down first, turned about the vertical so that it fits the film best. Best
// first, ten at most. The simulation runs on `module` in batches; the field is the project's at the
// coarsest resolution. Throws Error (no pose meets the film; the solver fails) or Cancelled.
// Deterministic.
std::vector<RankedPoses> searchPoses(const Project& project, const solver::SolverModule& module,
                                     const PoseSearchOptions& options, const Progress& progress);

} // namespace dipwright
