// The far end of a solver in a process of its own (OutOfProcessSolver.h).
#pragma once

#include <QString>
#include <cstdio>

namespace dipwright {

// Loads the module and does what is asked of it, until there is nobody to ask: then the process
// ends, whatever the module is at. Messages are those of SolverMessages.h, each after its length in
// bytes (8 bytes).
[[noreturn]] void serveSolver(const QString& modulePath, std::FILE* requests, std::FILE* answers);

} // namespace dipwright
