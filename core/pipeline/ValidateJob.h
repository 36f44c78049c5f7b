// Whether a job can be run, without running it.
#pragma once

#include "project/Project.h"
#include "solver/SolverRegistry.h"

#include <QStringList>

namespace dipwright {

// Throws Error for the first thing that would stop the job: no model, no such solver, a body that
// is not over its film, a sheet that does not fit its paper. Returns, as sentences, what will run
// and may not be what was meant.
QStringList validateJob(const Project& project, const SolverRegistry& registry);

} // namespace dipwright
