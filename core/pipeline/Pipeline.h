// Runs the main job: model → distance field → dip → texture → sheet. After an edit, computes only
// the affected steps again.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobOptions.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Runs the main job. Takes over the steps of `previous` (may be null) whose inputs did not change
// (StepInputs.h). If a GPU solver fails, the best CPU solver takes over and the notes say so.
// Throws Error or Cancelled. Touches no file except the field cache.
JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress);

// Returns the distance field of a result's body. Computes it, or reads it from the field cache, if
// no dip of the result needed it. Throws Cancelled.
std::shared_ptr<const DistanceField> distanceFieldOf(const JobResult& result,
                                                     const Progress& progress);

} // namespace dipwright
