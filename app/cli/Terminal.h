// Wraps the system calls of the command line. All other files here are the same on every platform.
#pragma once

#include "base/Progress.h"

namespace dipwright::cli {

bool standardErrorIsTerminal();

// Cancels `cancelToken` on SIGINT, SIGTERM or SIGHUP. A second signal ends the program. A file that
// exceeds the user's size limit causes a write error instead of a signal.
void cancelOnSignals(const CancelToken& cancelToken);

} // namespace dipwright::cli
