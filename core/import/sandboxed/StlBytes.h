// STL files as assimp reads them. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// What of an STL file, and how, is given to assimp 5.2.5, which takes a file for binary only where
// it ends with its last triangle, and knows the words of ASCII in small letters alone: without what
// stands after a binary file's triangles; ASCII that has its words in capitals in small letters;
// all else as it is. Throws Error where what stands after them would be further triangles. The
// bytes may be those of `source`, which has to outlive them.
QByteArray stlForAssimp(const ModelSource& source);

} // namespace dipwright
