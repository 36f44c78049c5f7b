// Which solver computes, and who takes over where a GPU is missing or fails: the one place where
// that is decided, for a run, for its check beforehand and for every other work on a solver.
#pragma once

#include "base/Error.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

struct SolverChoice {
    SolverInfo solver;
    QStringList notes;            // a sentence for the user each time that another takes over
    CancelToken cancelToken = {}; // of whoever waits until a solver is loaded
};

// The solver `wanted`, an id or "auto"; the best on the CPU in the place of one that needs a GPU
// and cannot have it. Throws Error where there is no such solver, or none to take its place;
// Cancelled.
SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry,
                          const CancelToken& cancelToken = {});

// Puts the best CPU solver into the choice when its GPU solver has failed with `error`. False, and
// nothing is changed, where it was not a GPU solver or there is none to take its place.
bool takeOver(SolverChoice& choice, const SolverRegistry& registry, const Error& error);

// Returns work(module) of the chosen solver's module. Where a GPU solver fails, the work is done
// again on the best CPU solver, which stays chosen. Throws what `work` throws on the last solver.
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
