// Which solver computes a job.
#pragma once

#include "solver/SolverRegistry.h"

namespace dipwright {

struct SolverChoice {
    QString id;
    QString note; // a sentence where another takes over from the one wanted, else empty
};

// The CPU solver of the highest priority that can run here, if any can.
std::optional<SolverInfo> bestCpuSolver(const SolverRegistry& registry);

// The solver `wanted`; the best on the CPU in the place of one that needs a GPU and cannot have it.
// Throws Error where there is no such solver, or none to take its place.
SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry);

} // namespace dipwright
