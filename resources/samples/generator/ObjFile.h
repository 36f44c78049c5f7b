// Models as Wavefront OBJ with their material and texture beside them.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright::samples {

// Writes NAME.obj, NAME.mtl and NAME.png into `folder`; one material with one texture. Throws
// Error.
void writeObj(const TexturedMesh& model, const QString& folder, const QString& name);

} // namespace dipwright::samples
