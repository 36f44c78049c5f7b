// Computes how far handling errors within the tolerances may move the colours of a job, and whether
// the zones keep their limits.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

// Computes the tolerances of all dips. `settings` may differ from the settings of the job's run,
// because they do not change its dips. If two dips share the body, a place is evaluated in each dip
// that gives at least half of the place's colour. If a GPU solver fails, the best CPU solver takes
// over. Uses all cores; deterministic. Throws Error or Cancelled.
JobTolerances jobTolerances(const JobResult& result, const ToleranceSettings& settings,
                            const SolverRegistry& registry, const Progress& progress);

} // namespace dipwright
