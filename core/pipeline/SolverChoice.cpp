#include "pipeline/SolverChoice.h"

#include "base/Error.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

} // namespace

std::optional<SolverInfo> bestCpuSolver(const SolverRegistry& registry) {
    std::optional<SolverInfo> best;
    for (const SolverInfo& solver : registry.solvers()) {
        if (solver.available && solver.deviceKind == QLatin1String("cpu") &&
            (!best || solver.priority > best->priority)) {
            best = solver;
        }
    }
    return best;
}

SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry) {
    try {
        registry.module(wanted); // loads it, or throws the reason why it cannot run
        return {wanted, {}};
    } catch (const Error& error) {
        const std::optional<SolverInfo> solver = registry.found(wanted);
        const bool needsGpu = solver && solver->deviceKind == QLatin1String("gpu");
        const std::optional<SolverInfo> other =
            needsGpu ? bestCpuSolver(registry) : std::optional<SolverInfo>();
        if (!other) {
            throw;
        }
        return {other->id,
                Text::tr("The CPU will take over from %1: %2").arg(solver->name, error.sentence())};
    }
}

} // namespace dipwright
