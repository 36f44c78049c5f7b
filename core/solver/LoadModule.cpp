#include "solver/LoadModule.h"

#include "solver/ModuleParts.h"
#include "solver/ModuleText.h"
#include "solver/OlderModule.h"

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

// The symbols of a module. The library stays loaded until the program ends.
struct Symbols {
    DipwrightSolverEntry* entry = nullptr;
    DipwrightUseProgramEntry* useProgram = nullptr;   // null: it needs no parts
    DipwrightSolverPartEntry* partOfModule = nullptr; // null: it has none
};

Symbols resolved(const QString& modulePath) {
    QLibrary library(modulePath);
    library.setLoadHints(QLibrary::ResolveAllSymbolsHint);
    if (!library.load()) {
        throw LoadFailure(LoadFault::NotLoadable, library.errorString());
    }
    const auto symbol = [&]<typename Function>(const char* name, Function*& function) {
        function = reinterpret_cast<Function*>(library.resolve(name));
    };
    Symbols symbols;
    symbol(DIPWRIGHT_SOLVER_ENTRY, symbols.entry);
    symbol(DIPWRIGHT_USE_PROGRAM_ENTRY, symbols.useProgram);
    symbol(DIPWRIGHT_SOLVER_PART_ENTRY, symbols.partOfModule);
    if (!symbols.entry) {
        throw LoadFailure(LoadFault::NoEntryPoint);
    }
    return symbols;
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

LoadedModule loadModule(const QString& modulePath, int builtFor) {
    const Symbols symbols = resolved(modulePath);
    LoadedModule loaded;
    if (symbols.useProgram) {
        guarded([&] { symbols.useProgram(&programPart); });
    }
    if (const solver::SolverModule* module = guarded([&] { return symbols.entry(builtFor); })) {
        const auto own = [](const solver::SolverModule*) {}; // the module owns it
        loaded.module = builtFor == solver::interfaceVersion
                            ? std::shared_ptr<const solver::SolverModule>(module, own)
                            : presentModule(module);
    } else {
        throw LoadFailure(LoadFault::DoesNotFit);
    }
    loaded.module = guarded([&] {
        return limitedModule(loaded.module, solver::part<solver::LimitsPart>(symbols.partOfModule));
    });
    if (const char* reason = guarded([&] { return loaded.module->unavailableReason(); })) {
        throw LoadFailure(LoadFault::Unavailable, QString::fromUtf8(reason));
    }
    if (const char* device = guarded([&] { return loaded.module->device(); })) {
        loaded.device = moduleText(QString::fromUtf8(device));
    }
    return loaded;
}

} // namespace dipwright
