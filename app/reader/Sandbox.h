// What this process gives up before it looks at anything from elsewhere. The system's side: Linux
// has all of it; other Unix the limits; Windows, where nobody has tried it, memory and processes.
#pragma once

#include <QtGlobal>

namespace dipwright {

// Whatever the program was started with that is not one of its three streams is closed, and it ends
// with whoever started it. First of all.
void leaveSurroundings();

// From now on: no file, network, process or memory that is run as a program can be had, nor what
// mostOf() allows for a file of no bytes be passed. Once; all libraries must be loaded by then.
// False where the system has a means of keeping the process from that and refuses it.
[[nodiscard]] bool enterSandbox();

// As much memory and time to compute as files of these many bytes together may take.
void allowFor(qint64 fileBytes);

} // namespace dipwright
