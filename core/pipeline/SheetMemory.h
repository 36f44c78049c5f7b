// How much memory the sheets of a job take, said before the work begins.
#pragma once

#include <QString>

namespace dipwright {

struct Project;

// Bytes at the peak of a run, of which the sheets' pictures and what is made of them take nearly
// all: measured per pixel (docs/speed.md, "Memory").
double sheetMemory(const Project& project);

// A sentence for the user where the sheets take a GB or more; empty otherwise.
QString memoryNote(const Project& project);

// Throws Error where they take more than this computer has.
void checkMemory(const Project& project);

} // namespace dipwright
