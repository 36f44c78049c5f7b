// Runs modules that were built for version 3 of the solver interface. Private to this folder.
#pragma once

#include <dipwright/FilmSolver.h>

#include <memory>

namespace dipwright {

inline constexpr int oldestInterface = 3;

// Returns a module of the present interface that passes everything on to a module of version 3.
// `older` is what the module's entry point returned. Such a module gets straight dips only. Version
// 4 added paths: a field at the end of DipSetup, and a function of SolverModule.
std::shared_ptr<const solver::SolverModule> presentModule(const void* older);

} // namespace dipwright
