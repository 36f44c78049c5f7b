// Confines this process before it reads foreign files. Linux supports the whole sandbox, other Unix
// systems only the limits. Windows limits memory and processes, and is untested.
#pragma once

#include "base/Budgets.h"

#include <QtGlobal>

namespace dipwright {

// Which limits of Budgets.h the process keeps.
struct ReaderLimits {
    Budget memory = Budget::Memory;
    Budget time = Budget::Milliseconds;
};

// Closes all inherited files except the three standard streams. On Linux, the process also ends
// when its parent ends. Call this function before anything else.
void closeInheritedFiles();

// From now on the process cannot use files, the network, other processes or new executable memory.
// It also has the limits that budgetLimit() gives for a file of 0 bytes. Call this once, after all
// libraries are loaded. Returns false if the system refuses its sandbox.
[[nodiscard]] bool enterSandbox(const ReaderLimits& limits);

// Raises the limits of memory and computing time to those for files of `fileBytes` bytes in total.
void raiseLimits(const ReaderLimits& limits, qint64 fileBytes);

} // namespace dipwright
