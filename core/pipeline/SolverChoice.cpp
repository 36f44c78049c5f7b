#include "pipeline/SolverChoice.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

// Returns the available CPU solver of the highest priority; none if `solver` needs no GPU.
std::optional<SolverInfo> cpuInPlaceOf(const SolverInfo& solver, const SolverRegistry& registry,
                                       const CancelToken& cancelToken) {
    std::optional<SolverInfo> best;
    if (solver.deviceKind != QLatin1String("gpu")) {
        return best;
    }
    for (const SolverInfo& candidate : registry.solvers(cancelToken)) {
        if (candidate.available && candidate.deviceKind == QLatin1String("cpu") &&
            (!best || candidate.priority > best->priority)) {
            best = candidate;
        }
    }
    return best;
}

} // namespace

SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry,
                          const CancelToken& cancelToken) {
    try {
        return {registry.info(wanted, cancelToken), {}, cancelToken};
    } catch (const Error& error) {
        const std::optional<SolverInfo> missing = registry.found(wanted, cancelToken);
        const auto other = missing ? cpuInPlaceOf(*missing, registry, cancelToken) : std::nullopt;
        if (!other) {
            throw;
        }
        return {*other,
                {Text::tr("The CPU is used instead of %1, which is not available: %2")
                     .arg(missing->name, error.sentence())},
                cancelToken};
    }
}

bool takeOver(SolverChoice& choice, const SolverRegistry& registry, const Error& error) {
    const std::optional<SolverInfo> other =
        cpuInPlaceOf(choice.solver, registry, choice.cancelToken);
    if (!other) {
        return false;
    }
    choice.notes.append(Text::tr("%2 took over, because %1 failed: %3")
                            .arg(choice.solver.name, other->name, error.sentence()));
    choice.solver = *other;
    return true;
}

} // namespace dipwright
