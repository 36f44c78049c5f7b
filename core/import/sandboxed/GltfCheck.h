// What glTF files (.gltf, .glb) need that assimp does not have, or reads as something else without
// a word. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Throws Error where a file cannot be read without an extension that is not read, or keeps places
// as whole numbers, which assimp 5.2 takes for floating-point ones; warns of pictures that are not
// read or lie otherwise than is meant. What is no JSON is left to assimp to refuse.
void checkGltf(const ModelSource& source, QStringList& warnings);

} // namespace dipwright
