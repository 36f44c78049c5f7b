// Loading a solver's module into this process.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QByteArray>
#include <QString>
#include <cstdint>
#include <exception>

namespace dipwright {

// Why a plugin cannot be used, as a sentence; caught where the list is made.
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
    NotLoadable, // by the system; the detail says why
    NoEntryPoint,
    FailedAtStart, // the detail is what it threw
    FailedUnknown,
    DoesNotFit, // this program's interface
    Unavailable // the detail is its own sentence
};

// As a value, so that a process without the user's language can hand it to one that has it.
class LoadFailure : public Refusal {
public:
    // As much of the detail is kept as may stand within a sentence (ModuleText.h).
    explicit LoadFailure(LoadFault fault, const QString& detail = {});
    LoadFault fault() const { return fault_; }
    const QString& detail() const { return detail_; }

private:
    LoadFault fault_;
    QString detail_;
};

struct LoadedModule {
    const solver::SolverModule* module = nullptr; // lives as long as the process
    QString device;                               // in words; empty where it tells none
};

// Loads the module and asks whether it can run here. Throws LoadFailure.
LoadedModule loadModule(const QString& modulePath);

} // namespace dipwright
