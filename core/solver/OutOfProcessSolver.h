// A solver's module in a process of its own, so that it can crash or hang and be left.
#pragma once

#include "base/Progress.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <memory>

namespace dipwright {

// Loads the module in a process of its own, the program dipwright-solver, and asks it whether it
// can run here. Throws Refusal (LoadModule.h), also where it crashes or takes too long; Cancelled.
//
// Every film and every batch of the module has a process of its own, which goes with it, as does
// all that the module has started there (ProcessGroup.h). Where it crashes or takes too long, or is
// killed, std::runtime_error is thrown with a sentence; the first two are remembered
// (LoadMarker.h). Its films are StoppableFilms. Error where that program is not there.
std::unique_ptr<solver::SolverModule> outOfProcessSolver(const QString& modulePath,
                                                         const CancelToken& cancelToken);

} // namespace dipwright
