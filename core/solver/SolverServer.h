// The server side of a solver in a separate process (OutOfProcessSolver.h).
#pragma once

#include <QString>
#include <cstdio>

namespace dipwright {

// Loads the module and answers requests until the client is gone; then the process ends, whatever
// the module is doing. Messages are those of SolverMessages.h, each preceded by its length in bytes
// (8 bytes).
[[noreturn]] void serveSolver(const QString& modulePath, std::FILE* requests, std::FILE* answers);

} // namespace dipwright
