// Sets up what the module needs once in each process: Qt's application object, the folders of
// Dipwright's programs and plugins, and the solvers. Private to this folder.
#pragma once

#include "solver/SolverRegistry.h"

namespace dipwright::python {

// Returns the solver plugins. The first call begins the session. If the process has no Qt
// application object, it creates one that needs no display, sets the program's name
// (base/ProgramName.h), and completes writes that killed programs left unfinished. Throws Error if
// the process has an application object that cannot draw text. The GIL must be held.
const SolverRegistry& session();

// Ends the session, before Python ends. The GIL must be held.
void endSession();

} // namespace dipwright::python
