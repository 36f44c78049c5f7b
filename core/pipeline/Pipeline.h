// model → field → dip → texture → sheet: the main job, of which an edit recomputes just what it
// must.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobOptions.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Runs the main job with what can be reused of `previous` (may be null): steps whose inputs did not
// change are taken over (StepInputs.h). Where a GPU solver fails, the best CPU solver takes over
// and the notes say so. Throws Error or Cancelled. Pure: touches no file but the field cache.
JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress);

} // namespace dipwright
