// Finds faces that overlap in one plane, as where two bodies of a model end in the same plane.
// Private to this folder.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright {

// Returns about the area, mm², on which two faces lie at the same place and face the same way, but
// have different materials or charts of a texture. Either may be printed there.
// Deterministic.
double overlappingArea(const TexturedMesh& model);

} // namespace dipwright
