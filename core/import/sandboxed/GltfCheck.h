// Checks glTF files (.gltf, .glb) for features that assimp lacks or misreads silently. Private to
// this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the file's bytes for assimp, without a byte order mark and with the changes of
// GltfPose.h.
// Throws Error if the file requires an unsupported extension, lacks a skin that a node uses or bind
// matrices for some joints of a skin, places meshes by an extension, scales by a rotation, or
// stores coordinates as integers, which assimp 5.2 takes for floating-point numbers. Warns of
// pictures that are not read or that are placed wrongly. Invalid JSON is left to assimp to refuse.
QByteArray gltfForAssimp(const ModelSource& source, QStringList& warnings);

} // namespace dipwright
