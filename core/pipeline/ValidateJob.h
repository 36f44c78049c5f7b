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

// Throws Error if the path of a dip cannot be travelled, or if the film model does not allow it.
// `project` must have a model.
void requirePath(const Project& project, const Immersion& immersion);

// Returns sentences (without the immersion's name) if the body lies beside the film or past its
// edge, or if the dip exceeds a limit of the project's tank (TankFit.h); otherwise empty. `project`
// must have a model. Takes about 2 ms for 100 000 vertices; on a path, as long for each moment.
QString misplacement(const Project& project, const Immersion& immersion);

} // namespace dipwright
