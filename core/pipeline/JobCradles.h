// The cradles of a job: one for each immersion, which keep off what the earlier ones have painted.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// In the order of the immersions, without a mesh where nothing can be held, and why in its notes.
// All cores; deterministic. Throws Error or Cancelled.
std::vector<Cradle> jobCradles(const JobResult& result, const Progress& progress);

} // namespace dipwright
