// Which solver computes a job.
#pragma once

#include "solver/SolverRegistry.h"

namespace dipwright {

struct SolverChoice {
    QString id;
    QString note; // a sentence where another takes over from the one wanted, else empty
};

// The solver `wanted`; the best that can run here in the place of one that needs a GPU and cannot
// have it. Throws Error where no solver, or no other, is wanted so.
SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry);

} // namespace dipwright
