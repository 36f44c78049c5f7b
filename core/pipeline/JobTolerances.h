// How far the colours of a job may land off their places for its tolerances, and whether its zones
// keep their limits.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

// By `settings`, which need not be those that the job was run with, as they change no dip of it.
// Where two dips share the body out, a place counts where its dip gives at least half of the
// colour. Where a GPU solver fails, the best CPU solver takes over. All cores; deterministic.
// Throws Error or Cancelled.
JobTolerances jobTolerances(const JobResult& result, const ToleranceSettings& settings,
                            const SolverRegistry& registry, const Progress& progress);

} // namespace dipwright
