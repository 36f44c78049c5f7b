// A module in this process whose calls are watched for hangs.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QString>
#include <memory>

namespace dipwright {

// Timeout in seconds for one call of a module: a step, or the work before the first step. For a
// batch it is the timeout between two signs of life (its questions whether it is cancelled).
// DIPWRIGHT_SOLVER_SECONDS replaces `longestCall`, 1 … 86,400.
inline constexpr int longestCall = 120;
int secondsOfACall();
// Timeout in seconds until a module in its own process is loaded and says whether it can run here.
// No film is computed then, but a GPU's driver may need several seconds to start. The variable sets
// this, too.
inline constexpr int longestDescription = 20;
int secondsOfADescription();

// Returns the same module with watched calls. A call in this process cannot be ended from outside;
// only the process can. A call that takes longer than secondsOfACall() is recorded like a crash
// (LoadMarker.h), at once and by a separate thread. The next start then runs the module in its own
// process. Keeps a reference to the module.
std::unique_ptr<solver::SolverModule> watchedSolver(const solver::SolverModule& module,
                                                    const QString& modulePath);

} // namespace dipwright
