// Prepares STL files for assimp. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the bytes of an STL file for assimp 5.2.5. assimp takes a file for binary only if it ends
// with the last triangle, and for ASCII only if it begins with "solid". It knows ASCII keywords in
// small letters only. So bytes after the triangles of a binary file are removed. From an ASCII
// file, empty lines round the text are removed, and capitals become small letters.
// Throws Error if the bytes after the triangles may be further triangles. The result may share the
// bytes of `source`, which must outlive it.
QByteArray stlForAssimp(const ModelSource& source);

} // namespace dipwright
