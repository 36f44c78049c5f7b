// Simulates a dip deeper than the job's, to show how the depth changes the painted area.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// The largest additional depth, which stands for an error at the tank.
inline constexpr Millimetres mostDeeper{10};

// Simulates a dip of the job again with the same film cells, deeper by mostDeeper or until the
// whole body is under water. The process must have a depth; without a depth the whole body is
// already dipped. If a GPU solver fails, the best CPU solver takes over. Throws Error or Cancelled.
std::shared_ptr<const LaidFilm> deeperDip(const JobResult& result, std::size_t immersion,
                                          const SolverRegistry& registry, const Progress& progress);

} // namespace dipwright
