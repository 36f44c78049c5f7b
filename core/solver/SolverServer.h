// The server side of a solver in a separate process (OutOfProcessSolver.h).
#pragma once

#include <QString>
#include <cstdio>

namespace dipwright {

// Loads the module and answers requests until the client is gone. Then the process ends, whatever
// the module is doing. Messages have the format of SolverMessages.h. Each is preceded by its length
// in bytes, as an 8-byte number.
[[noreturn]] void serveSolver(const QString& modulePath, int builtFor, std::FILE* requests,
                              std::FILE* answers);

} // namespace dipwright
