// Chooses the solver, and the CPU solver that takes over if a GPU is missing or fails. Runs, checks
// before a run, and all other work with solvers use this.
#pragma once

#include "base/Error.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

// The chosen solver and why it was chosen.
struct SolverChoice {
    SolverInfo solver;
    QStringList notes;            // one sentence for the user for each take-over
    CancelToken cancelToken = {}; // cancels waiting for a solver to load
};

// Returns the solver `wanted`, an id or "auto". If it needs a GPU and has none, the best CPU solver
// takes its place. Throws Error if there is no such solver and none to replace it, or Cancelled.
SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry,
                          const CancelToken& cancelToken = {});

// Replaces a GPU solver that failed with `error` by the best CPU solver. Returns false and changes
// nothing if it was not a GPU solver or there is no replacement.
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
