// Checks 3DS files for features that programs apply in different ways. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the file's bytes for assimp, with a master scale of 1. assimp 5.2.5 divides lengths by
// the master scale, other programs multiply them by it or ignore it. Warns of another master scale,
// and of objects that their matrix mirrors: assimp mirrors them only if the file has keyframes.
// Damage is left to assimp to refuse.
QByteArray threeDsForAssimp(const ModelSource& source, QStringList& warnings);

} // namespace dipwright
