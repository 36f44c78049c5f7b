// Reads models by assimp. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

#include <QStringList>

namespace dipwright {

// `format` is "obj", "stl", "gltf", "glb", "dae", "fbx" or "3ds"; others are refused. Only the
// assimp loader of that format is registered; assimp would otherwise try its fifty loaders in turn.
// Throws Error.
TexturedMesh readByAssimp(const QString& format, const ModelSource& source, QStringList& warnings,
                          const Progress& progress);

} // namespace dipwright
