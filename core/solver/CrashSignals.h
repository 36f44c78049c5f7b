// Crash detection: what counts as a crash, and how a crashing process reports it. System-dependent.
#pragma once

namespace dipwright {

// From now on a crash of this process (invalid address, illegal instruction, abort) writes a byte
// to the open file `handle`. Then the process ends as usual. −1 switches this off. Only one file
// can be set at a time.
void reportCrashesTo(int handle);

// Whether a process that this signal ended has crashed. If not, it was killed: by the system for
// lack of memory, by a time limit, or by the user.
bool isCrash(int signal);

} // namespace dipwright
