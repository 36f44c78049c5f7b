// From what assimp read to a textured mesh, not yet repaired. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

struct aiScene;

namespace dipwright {

// All triangles of the scene, its nodes' transforms applied. `linearColours`: material colours are
// linear light (glTF), not sRGB. Adds to `warnings` what had to be left out. Throws Error.
TexturedMesh convertScene(const aiScene& scene, const ModelSource& source, bool linearColours,
                          QStringList& warnings, const Progress& progress);

} // namespace dipwright
