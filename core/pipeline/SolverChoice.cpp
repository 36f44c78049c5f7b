#include "pipeline/SolverChoice.h"

#include "base/Error.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

} // namespace

SolverChoice chooseSolver(const QString& wanted, const SolverRegistry& registry) {
    try {
        registry.module(wanted); // loads it, or throws the reason why it cannot run
        return {wanted, {}};
    } catch (const Error& error) {
        const std::optional<SolverInfo> solver = registry.found(wanted);
        if (!solver || solver->deviceKind != QLatin1String("gpu")) {
            throw;
        }
        const QString other = registry.info(QStringLiteral("auto")).id;
        return {other,
                Text::tr("The CPU will take over from %1: %2").arg(solver->name, error.sentence())};
    }
}

} // namespace dipwright
