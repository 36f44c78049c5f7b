// Finds the sets of texture coordinates that the textures of an FBX file name. Private to this
// folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

struct aiScene;

namespace dipwright {

// In FBX a texture names its set of texture coordinates. assimp 5.2.5 looks for the name in the
// first mesh with the texture's material, and keeps only the set's number. Exchanges sets of the
// other meshes, so that the set with this name has this number there, too. Adds a warning if this
// is not possible and makes a difference.
void alignFbxTextureSets(const aiScene& scene, const ModelSource& source, QStringList& warnings);

} // namespace dipwright
