#include "solver/LoadModule.h"

#include "solver/ModuleText.h"

#include <QCoreApplication>
#include <QLibrary>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SolverRegistry)
};

QString sentenceOf(LoadFault fault, const QString& detail) {
    switch (fault) {
    case LoadFault::NotLoadable:
        return Text::tr("Its module cannot be loaded: %1").arg(detail);
    case LoadFault::NoEntryPoint:
        return Text::tr("Its module has no entry point %1")
            .arg(QLatin1String(DIPWRIGHT_SOLVER_ENTRY));
    case LoadFault::FailedAtStart:
        if (!detail.isEmpty()) {
            return Text::tr("Its module failed at start: %1").arg(detail);
        }
        [[fallthrough]];
    case LoadFault::FailedUnknown:
        return Text::tr("Its module failed at start with an unknown exception");
    case LoadFault::DoesNotFit:
        return Text::tr("Its module does not match this program's solver interface %1, although "
                        "its description file says that it does; build it again")
            .arg(solver::interfaceVersion);
    case LoadFault::Unavailable:
        break;
    }
    return detail.isEmpty() ? Text::tr("It cannot run here and does not say why; ask its author")
                            : detail;
}

DipwrightSolverEntry* resolvedEntry(const QString& modulePath) {
    QLibrary library(modulePath);
    library.setLoadHints(QLibrary::ResolveAllSymbolsHint);
    if (!library.load()) {
        throw LoadFailure(LoadFault::NotLoadable, library.errorString());
    }
    const auto entry =
        reinterpret_cast<DipwrightSolverEntry*>(library.resolve(DIPWRIGHT_SOLVER_ENTRY));
    if (!entry) {
        throw LoadFailure(LoadFault::NoEntryPoint);
    }
    return entry; // the library stays loaded until the program ends
}

// Runs the module's own code and turns its exceptions into refusals.
template <typename Call>
auto guarded(const Call& call) {
    try {
        return call();
    } catch (const std::exception& error) {
        throw LoadFailure(LoadFault::FailedAtStart, QString::fromUtf8(error.what()));
    } catch (...) {
        throw LoadFailure(LoadFault::FailedUnknown);
    }
}

} // namespace

LoadFailure::LoadFailure(LoadFault fault, const QString& detail)
    : Refusal(sentenceOf(fault, moduleText(detail))), fault_(fault), detail_(moduleText(detail)) {}

LoadedModule loadModule(const QString& modulePath) {
    DipwrightSolverEntry* const entry = resolvedEntry(modulePath);
    LoadedModule loaded;
    loaded.module = guarded([entry] { return entry(solver::interfaceVersion); });
    if (!loaded.module) {
        throw LoadFailure(LoadFault::DoesNotFit);
    }
    if (const char* reason = guarded([&] { return loaded.module->unavailableReason(); })) {
        throw LoadFailure(LoadFault::Unavailable, QString::fromUtf8(reason));
    }
    if (const char* device = guarded([&] { return loaded.module->device(); })) {
        loaded.device = moduleText(QString::fromUtf8(device));
    }
    return loaded;
}

} // namespace dipwright
