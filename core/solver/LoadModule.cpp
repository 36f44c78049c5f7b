#include "solver/LoadModule.h"

#include <QCoreApplication>
#include <QLibrary>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SolverRegistry)
};

DipwrightSolverEntry* resolvedEntry(const QString& modulePath) {
    QLibrary library(modulePath);
    library.setLoadHints(QLibrary::ResolveAllSymbolsHint);
    if (!library.load()) {
        throw Refusal(Text::tr("Its module cannot be loaded: %1").arg(library.errorString()));
    }
    const auto entry =
        reinterpret_cast<DipwrightSolverEntry*>(library.resolve(DIPWRIGHT_SOLVER_ENTRY));
    if (!entry) {
        throw Refusal(Text::tr("Its module has no entry point %1")
                          .arg(QLatin1String(DIPWRIGHT_SOLVER_ENTRY)));
    }
    return entry; // the library stays loaded until the program ends
}

// Runs the module's own code and turns whatever it throws into a refusal.
template <typename Call>
auto guarded(const Call& call) {
    try {
        return call();
    } catch (const std::exception& error) {
        throw Refusal(
            Text::tr("Its module failed at start: %1").arg(QString::fromUtf8(error.what())));
    } catch (...) {
        throw Refusal(Text::tr("Its module failed at start with an unknown exception"));
    }
}

} // namespace

LoadedModule loadModule(const QString& modulePath) {
    DipwrightSolverEntry* const entry = resolvedEntry(modulePath);
    LoadedModule loaded;
    loaded.module = guarded([entry] { return entry(solver::interfaceVersion); });
    if (!loaded.module) {
        throw Refusal(Text::tr("Its module does not fit this program's solver interface %1, "
                               "whatever its description says; build it anew")
                          .arg(solver::interfaceVersion));
    }
    if (const char* reason = guarded([&] { return loaded.module->unavailableReason(); })) {
        throw Refusal(QString::fromUtf8(reason));
    }
    if (const char* device = guarded([&] { return loaded.module->device(); })) {
        loaded.device = QString::fromUtf8(device);
    }
    return loaded;
}

} // namespace dipwright
