// A module in this process that is watched while it is called.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QString>
#include <memory>

namespace dipwright {

// How long a module may be at one call, be it a step or what comes before the first, and between
// two signs of life of a batch (it asks whether it is cancelled): seconds. DIPWRIGHT_SOLVER_SECONDS
// sets another than `longestCall`, 1 … 86,400.
inline constexpr int longestCall = 120;
int secondsOfACall();
// How long one in a process of its own may take to be loaded and to say whether it can run here: no
// film is waited for then, but a GPU's driver that starts may take several seconds. The variable
// sets this, too.
inline constexpr int longestDescription = 20;
int secondsOfADescription();

// The same module. A call in this process cannot be ended from outside, only the process can. But
// one that takes longer than secondsOfACall() is remembered as a crash is (LoadMarker.h), at once
// and by a thread of its own, so that the next start gives the module a process of its own. Keeps a
// reference to the module.
std::unique_ptr<solver::SolverModule> watchedSolver(const solver::SolverModule& module,
                                                    const QString& modulePath);

} // namespace dipwright
