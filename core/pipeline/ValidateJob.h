// Whether a job can be run, without running it.
#pragma once

#include "solver/SolverRegistry.h"

#include <QStringList>

namespace dipwright {

struct Project;
struct Immersion;

// Throws Error for the first thing that would stop the job: no model, no such solver, a body that
// is not over its film, a sheet that does not fit its paper. Returns, as sentences, what will run
// and may not be what was meant.
QStringList validateJob(const Project& project, const SolverRegistry& registry);

// What is wrong with where an immersion's body lies, as a sentence without the immersion's name:
// beside the film, past its edge, or past the tank's where the project has a tank; empty: nothing.
// `project` has a model. Takes about a millisecond for a hundred thousand vertices.
QString misplacement(const Project& project, const Immersion& immersion);

} // namespace dipwright
