// Runs a solver's module in a separate process, so that it can crash or hang without harm.
#pragma once

#include "base/Progress.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <memory>

namespace dipwright {

// Loads the module in a separate process, the program dipwright-solver, and asks it whether it can
// run here. `builtFor` is as for loadModule(). Throws Refusal (LoadModule.h) if the module cannot
// run, crashes or takes too long. Throws Cancelled if cancelled.
//
// Each film and each batch of the module has its own process. The process ends with the film or
// batch, and so does everything that the module started there (ProcessGroup.h). If the process
// crashes, takes too long or is killed, std::runtime_error is thrown with a message. Crashes and
// timeouts are remembered (LoadMarker.h). The films are StoppableFilms. Throws Error if
// dipwright-solver is missing.
std::unique_ptr<solver::SolverModule> outOfProcessSolver(const QString& modulePath, int builtFor,
                                                         const CancelToken& cancelToken);

} // namespace dipwright
