// Writes models as Wavefront OBJ with material and texture.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright::samples {

// Writes NAME.obj, NAME.mtl and NAME.png into `folder`, with one material and one texture. Throws
// Error.
void writeObj(const TexturedMesh& model, const QString& folder, const QString& name);

} // namespace dipwright::samples
