// Simulates a dip deeper than the job's, to show how the depth changes the painted area.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// The additional depth at most: it stands for an error at the tank.
inline constexpr Millimetres mostDeeper{10};

// Dips an immersion of the job again with the same film cells, deeper by mostDeeper or until the
// whole body is dipped. The process must have a depth; otherwise the whole body is dipped already.
// If a GPU solver fails, the best CPU solver takes over. Throws Error or Cancelled.
std::shared_ptr<const LaidFilm> deeperDip(const JobResult& result, std::size_t immersion,
                                          const SolverRegistry& registry, const Progress& progress);

} // namespace dipwright
