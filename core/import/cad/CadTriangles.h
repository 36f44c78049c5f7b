// Approximates the faces of a CAD model by triangles. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/cad/CadFaces.h"
#include "import/trusted/UntrustedFiles.h"

namespace dipwright {

// The triangles of the faces, one material for each face. Sets `used` to the tolerance that was
// used, mm on the part. Adds a warning for faces that cannot be cut into triangles. Throws Error if
// there are too many triangles.
TexturedMesh cadTriangles(const CadFaces& faces, const Tessellation& tessellation, double& used,
                          QStringList& warnings, const QString& path, const Progress& progress);

} // namespace dipwright
