// Estimates the memory that the sheets of a job need, before the work begins.
#pragma once

#include <QString>

namespace dipwright {

struct Project;

// Returns the peak memory of a run in bytes. The sheets' pictures take nearly all of it; measured
// per pixel (docs/speed.md, "Memory").
double sheetMemory(const Project& project);

// Returns a sentence for the user if the sheets need 1 GB or more; otherwise empty.
QString memoryNote(const Project& project);

// Throws Error if the sheets need more memory than this computer has.
void checkMemory(const Project& project);

} // namespace dipwright
