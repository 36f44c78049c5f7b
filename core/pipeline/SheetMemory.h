// Estimates the memory that the sheets of a job need, before the work begins.
#pragma once

#include <QString>

namespace dipwright {

struct Project;

// Returns the peak memory of a run in bytes, estimated from measured bytes per pixel of the sheets'
// pictures (docs/speed.md, "Memory"). Other data hardly count.
double sheetMemory(const Project& project);

// Returns a sentence for the user if the sheets need 1 GB or more; otherwise empty.
QString memoryNote(const Project& project);

// Throws Error if the sheets need more memory than this computer has.
void checkMemory(const Project& project);

} // namespace dipwright
