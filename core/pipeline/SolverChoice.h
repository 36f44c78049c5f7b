// Chooses the solver, and the CPU solver that takes over if a GPU is missing or fails. All work
// with solvers uses this file.
#pragma once

#include "base/Error.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

// The chosen solver and notes on solvers that were replaced.
struct SolverChoice {
    SolverInfo solver;
    QStringList notes;            // for the user: one sentence for each replaced solver
    CancelToken cancelToken = {}; // cancels the wait while a solver loads
};

// Returns the solver `wanted`, an id or "auto". If this solver needs a GPU and finds none, returns
// the best CPU solver. Throws Error if there is no such solver and no replacement. Throws
// Cancelled.
SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry,
                          const CancelToken& cancelToken = {});

// Replaces a GPU solver that failed with `error` by the best CPU solver. Returns false and changes
// nothing if the failed solver needs no GPU or there is no replacement.
bool takeOver(SolverChoice& choice, const SolverRegistry& registry, const Error& error);

// Returns work(module) for the chosen solver's module. If a GPU solver fails, repeats the work on
// the best CPU solver, which stays chosen. Throws what `work` throws on the last solver.
template <typename Work>
auto withFallback(SolverChoice& choice, const SolverRegistry& registry, const Work& work) {
    try {
        return work(registry.module(choice.solver.id, choice.cancelToken));
    } catch (const Error& error) {
        if (!takeOver(choice, registry, error)) {
            throw;
        }
        return work(registry.module(choice.solver.id, choice.cancelToken));
    }
}

} // namespace dipwright
