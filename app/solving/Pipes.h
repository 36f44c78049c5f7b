// Handles the pipes and signals between this process and the program that started it.
#pragma once

#include <cstdio>

namespace dipwright {

// Returns the former standard output as a binary stream. From now on, text that a module prints
// goes to standard error. Standard input becomes binary, too.
std::FILE* answerPipe();

// Ignores interrupts. The terminal may send them to this process too, but the starting program
// decides when this process ends.
void leaveInterruptsToStarter();

} // namespace dipwright
