// STL files as assimp reads them. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// The bytes of an STL file as they are given to assimp 5.2.5. It takes a file for binary only where
// the file ends with its last triangle, and an ASCII file only where its first line begins with
// "solid"; it knows the words of ASCII in small letters alone. So a binary file loses what stands
// after its triangles, an ASCII file the empty lines round its text, and words in capitals become
// small. All else stays as it is. Throws Error where what stands after the triangles would be
// further triangles. The bytes may be those of `source`, which has to outlive them.
QByteArray stlForAssimp(const ModelSource& source);

} // namespace dipwright
