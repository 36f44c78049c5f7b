// What glTF files (.gltf, .glb) need that assimp does not have, or reads as something else without
// a word. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Throws Error where a file cannot be read without an extension that is not read, or keeps places
// as whole numbers, which assimp 5.2 takes for floating-point ones; warns of pictures that are not
// read or lie otherwise than is meant. What is no JSON is left to assimp to refuse. Returns the
// file's bytes for assimp: without a byte order mark, and without skins that have no bind matrices,
// which glTF 2.0 allows ("Skins") and at which assimp 5.2.5 crashes; that is warned of, too.
QByteArray gltfForAssimp(const ModelSource& source, QStringList& warnings);

} // namespace dipwright
