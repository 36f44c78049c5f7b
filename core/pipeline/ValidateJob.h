// Checks whether a job can be run, without running it.
#pragma once

#include "solver/SolverRegistry.h"

#include <QStringList>

namespace dipwright {

struct Project;
struct Immersion;

// Returns warnings as sentences. Throws Error for the first fault that would stop the job: no
// model, no such solver, a body not over its film, or a sheet larger than its paper.
QStringList validateJob(const Project& project, const SolverRegistry& registry);

// Returns a sentence (without the immersion's name) if the body lies beside the film, past its
// edge, or past the edge of the project's tank; otherwise empty. `project` must have a model. Takes
// about 1 ms for 100 000 vertices.
QString misplacement(const Project& project, const Immersion& immersion);

} // namespace dipwright
