// What of a job goes to the tank.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "traveller/Traveller.h"

namespace dipwright {

DipMotion jobMotion(const JobResult& result, std::size_t immersion);
// Draws its pictures: all cores; deterministic. Throws Cancelled.
Traveller jobTraveller(const JobResult& result, const Progress& progress);

} // namespace dipwright
