// Estimates the memory that the sheets of a job need, before the work begins.
#pragma once

#include <QString>

namespace dipwright {

struct Project;

// What a run prints on its films.
enum class Printed { Texture, WholeFilm };

// Returns the peak memory of a run in bytes, estimated from measured bytes per printed pixel
// (docs/speed.md, "Memory"). Blank film needs no memory: with a texture, at most the body's surface
// counts, with a margin for bleed and folds. All other data are small in comparison.
double sheetMemory(const Project& project, Printed printed);

// Returns a sentence for the user if the sheets need 1 GB or more; otherwise empty.
QString memoryNote(const Project& project, Printed printed);

// Throws Error if the sheets need more memory than this computer has.
void checkMemory(const Project& project, Printed printed);

} // namespace dipwright
