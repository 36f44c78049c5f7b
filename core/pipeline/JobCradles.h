// Makes the cradles of a job, one for each dip. A cradle avoids the area that earlier dips painted.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Returns the cradles in the order of the dips. A cradle that cannot hold the body has no mesh, and
// its notes say why. Uses all cores; deterministic. Throws Error or Cancelled.
std::vector<Cradle> jobCradles(const JobResult& result, const Progress& progress);

} // namespace dipwright
