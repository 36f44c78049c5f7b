// From what assimp read to a textured mesh, not yet repaired. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/MaterialFileCheck.h"
#include "import/sandboxed/ModelSource.h"

struct aiScene;

namespace dipwright {

// What the scene itself does not tell.
struct SceneMeaning {
    bool linearColours = false; // material colours are linear light (glTF), not sRGB
    PicturePlacements placements;
};

// All triangles of the scene, its nodes' transforms and its pictures' placements applied. Adds to
// `warnings` what had to be left out. Throws Error.
TexturedMesh convertScene(const aiScene& scene, const ModelSource& source,
                          const SceneMeaning& meaning, QStringList& warnings,
                          const Progress& progress);

} // namespace dipwright
