// Loads a solver's module into this process.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QByteArray>
#include <QString>
#include <cstdint>
#include <exception>
#include <memory>

namespace dipwright {

// The reason why a plugin cannot be used, as a sentence. Caught where the list of solvers is made.
class Refusal : public std::exception {
public:
    explicit Refusal(QString reason) : reason_(std::move(reason)), bytes_(reason_.toUtf8()) {}
    const QString& reason() const { return reason_; }
    const char* what() const noexcept override { return bytes_.constData(); }

private:
    QString reason_;
    QByteArray bytes_;
};

// What can be wrong with a module.
enum class LoadFault : std::uint8_t {
    NotLoadable, // the system cannot load it; the detail says why
    NoEntryPoint,
    FailedAtStart, // the detail is the message of the module's exception
    FailedUnknown,
    DoesNotFit, // built for another version of the solver interface
    Unavailable // the detail is the module's own sentence
};

// A refusal that keeps fault and detail apart. A process that does not know the user's language can
// pass them to a process that translates them.
class LoadFailure : public Refusal {
public:
    // The detail is shortened as ModuleText.h says.
    explicit LoadFailure(LoadFault fault, const QString& detail = {});
    LoadFault fault() const { return fault_; }
    const QString& detail() const { return detail_; }

private:
    LoadFault fault_;
    QString detail_;
};

struct LoadedModule {
    std::shared_ptr<const solver::SolverModule> module; // its code stays loaded
    QString device; // the module's description for the user; empty if it gives none
};

// Loads the module, exchanges parts with it, and asks whether it can run here. `builtFor`: the
// version of the solver interface for which it says it was built. Throws LoadFailure.
LoadedModule loadModule(const QString& modulePath, int builtFor);

} // namespace dipwright
