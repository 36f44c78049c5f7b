// Reads CAD files (STEP, IGES) from untrusted bytes and approximates their surfaces by triangles.
//
// Each face of the file becomes a material with the face's name and colour, so that zones, masks
// and artwork can name faces, and keep them when the triangles are made again. An unnamed face is
// called "Face 12", by its number in the file. Names that occur several times get a number: "Logo
// (2)". A face without a colour has that of its part, or none.
#pragma once

#include "base/Progress.h"
#include "import/trusted/UntrustedFiles.h"

namespace dipwright {

// Loads what OpenCASCADE loads from files. Call it once, before the sandbox is entered.
void prepareCad();

// Reads the CAD file `path` through `files`. The mesh is in mm as the file says, unscaled. Throws
// Error if the file is damaged, has no surfaces or exceeds Budgets.h. Not for several threads.
UntrustedModel readCad(const QString& path, UntrustedFiles& files, const Tessellation& tessellation,
                       const Progress& progress);

} // namespace dipwright
