// Finds in an FBX file what assimp 5.2.5 reads wrongly without an error. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Adds to `warnings` what assimp leaves out of an FBX file, which is text or binary: layers of
// textures, other materials of an object that shares its mesh, how an object inherits a scale
// (FBX SDK, FbxTransform::EInheritType), and that an object is hidden.
void checkFbx(const ModelSource& source, QStringList& warnings);

} // namespace dipwright
