// Prepares STL files for assimp. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the bytes of an STL file for assimp 5.2.5. assimp takes a file for binary only if it ends
// with the last triangle, and for ASCII only if it begins with "solid". It knows ASCII keywords in
// lower case only. So bytes after the triangles of a binary file are removed. In an ASCII file,
// empty lines before and after the text are removed, and capitals become lower case.
// Throws Error if the bytes after the triangles may be further triangles, or if no "endsolid"
// follows the last triangle of a text. The result may share the bytes of `source`, which must
// outlive it.
QByteArray stlForAssimp(const ModelSource& source);

} // namespace dipwright
