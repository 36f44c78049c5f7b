// Runs a job again with smaller film cells until its sheets can be printed.
#pragma once

#include "pipeline/JobOptions.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Default limit of the work of one dip, points × steps: about 20 s on two cores.
inline constexpr double defaultWork = 60e6;

// Runs the job (runJob()). While the numerical error of a sheet is too large to print it, runs
// the job again with the film cells that the verdict proposes, or half as large. Stops before a dip
// would need more than `work` points × steps, so that every computer stops at the same cells. The
// result's project has the cells that were used (FilmResolution::Cell), and a note names them or
// says why the film stayed as it was. Other reasons of the verdict stay: smaller cells do not
// change them. Throws like runJob().
JobResult runUntilPrint(const Project& project, const SolverRegistry& registry,
                        const JobOptions& options, double work, const Progress& progress);

} // namespace dipwright
