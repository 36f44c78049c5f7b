// What a crash is, and how a process that crashes gets a word out: the system's part.
#pragma once

namespace dipwright {

// From now on a crash of this process (a wrong address, an illegal instruction, an abort) writes a
// byte to the open file `handle` before the process ends of it as ever; −1: no more. One file at a
// time.
void tellCrashesTo(int handle);

// Whether a process that has ended of this signal crashed: it may as well have been killed, by the
// system for want of memory, at a limit of time, or by the user.
bool isCrash(int signal);

} // namespace dipwright
