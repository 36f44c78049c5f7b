// What the system is asked: the only file here with calls that differ between platforms.
#pragma once

#include "base/Progress.h"

namespace dipwright::cli {

bool standardErrorIsTerminal();

// An interrupt or a request to terminate cancels `cancelToken`, a second one ends the program. A
// file grown past the user's limit becomes an error of the write instead of a signal.
void cancelOnSignals(const CancelToken& cancelToken);

} // namespace dipwright::cli
