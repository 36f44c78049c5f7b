// Loads a solver's module into this process.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QByteArray>
#include <QString>
#include <cstdint>
#include <exception>

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
    const solver::SolverModule* module = nullptr; // lives as long as the process
    QString device; // the module's description for the user; empty if it gives none
};

// Loads the module and asks whether it can run here. Throws LoadFailure.
LoadedModule loadModule(const QString& modulePath);

} // namespace dipwright
