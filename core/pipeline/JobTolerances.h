// Computes how far the colours of a job may land from their places within the tolerances, and
// whether the zones keep their limits.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

// `settings` may differ from those that the job was run with, because they do not change its dips.
// If two dips share the body, a place counts for the dip that gives at least half of the colour. If
// a GPU solver fails, the best CPU solver takes over. All cores; deterministic. Throws Error or
// Cancelled.
JobTolerances jobTolerances(const JobResult& result, const ToleranceSettings& settings,
                            const SolverRegistry& registry, const Progress& progress);

} // namespace dipwright
