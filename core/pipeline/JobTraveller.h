// Makes the traveller of a job and the motion of its dips.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "traveller/TankTasks.h"
#include "traveller/Traveller.h"

namespace dipwright {

// Returns the motion of a dip.
DipMotion jobMotion(const JobResult& result, std::size_t immersion);
// Returns the steps at the tank. `path` is the project's file.
TankJob jobAtTank(const JobResult& result, const QString& path);
// Returns the traveller with its pictures. Uses all cores; deterministic. Throws Cancelled.
Traveller jobTraveller(const JobResult& result, const Progress& progress);

} // namespace dipwright
