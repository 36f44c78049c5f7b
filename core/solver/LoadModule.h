// Loading a solver's module into this process.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QString>
#include <exception>

namespace dipwright {

// Why a plugin cannot be used; caught where the list is made.
class Refusal : public std::exception {
public:
    explicit Refusal(QString reason) : reason_(std::move(reason)) {}
    const QString& reason() const { return reason_; }

private:
    QString reason_;
};

struct LoadedModule {
    const solver::SolverModule* module = nullptr; // lives as long as the process
    QString device;                               // in words; empty where it tells none
};

// Loads the module and asks whether it can run here. Throws Refusal.
LoadedModule loadModule(const QString& modulePath);

} // namespace dipwright
