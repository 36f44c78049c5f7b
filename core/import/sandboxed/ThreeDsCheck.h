// Checks 3DS files for features that programs apply in different ways. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the file's bytes for assimp, with a master scale of 1. assimp 5.2.5 divides lengths by
// the master scale, other programs multiply them by it or ignore it. Warns of another master scale,
// of objects that their matrix mirrors, which assimp mirrors only if the file has keyframes, and of
// chunks whose sizes do not fit into each other. assimp 5.2.5 refuses such files; another version
// may read them.
QByteArray threeDsForAssimp(const ModelSource& source, QStringList& warnings);

} // namespace dipwright
