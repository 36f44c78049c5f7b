// The formats that assimp reads for us. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

#include <QStringList>

namespace dipwright {

// `format`: "obj", "stl", "gltf", "glb", "dae", "fbx" or "3ds"; others are refused. Of assimp's
// fifty loaders, which it would try one after the other, only the one for this format is there.
// Throws Error.
TexturedMesh readByAssimp(const QString& format, const ModelSource& source, QStringList& warnings,
                          const Progress& progress);

} // namespace dipwright
