// The pipes to the program that started this one: the system's part.
#pragma once

#include <cstdio>

namespace dipwright {

// What was standard output, as bytes; what a module prints goes to standard error from now on.
// Standard input gives bytes, too.
std::FILE* answerPipe();

// An interrupt from the keyboard may go to this process as well, where it has no group of its own,
// but what becomes of it is for the program that started it to say, with which it ends.
void leaveInterruptsToStarter();

} // namespace dipwright
