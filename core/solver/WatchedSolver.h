// A module in this process whose calls are watched for hangs.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QString>
#include <memory>

namespace dipwright {

// Timeout in seconds for one call of a module: a step, or the work before the first step. For a
// batch, it is the timeout between two calls of its CancelFunction. The environment variable
// DIPWRIGHT_SOLVER_SECONDS, 1 … 86,400, replaces `longestCall`.
inline constexpr int longestCall = 120;
int callTimeoutSeconds();
// Timeout in seconds until a module in its own process is loaded and says whether it can run here.
// No film is computed then, but a GPU's driver may need several seconds to start.
// DIPWRIGHT_SOLVER_SECONDS replaces this limit, too.
inline constexpr int longestDescription = 20;
int descriptionTimeoutSeconds();

// Returns the same module with watched calls. A call in this process cannot be interrupted; only
// the whole process can be ended. A call that takes longer than callTimeoutSeconds() is recorded
// like a crash (LoadMarker.h), at once and by a separate thread. The next start then runs the
// module in its own process. Keeps a reference to the module.
std::unique_ptr<solver::SolverModule> watchedSolver(const solver::SolverModule& module,
                                                    const QString& modulePath);

} // namespace dipwright
