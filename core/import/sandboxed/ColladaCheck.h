// Finds damage to Collada files (.dae) that assimp 5.2.5 misreads silently: it reads past the end
// of an array, takes a negative index for 0, and ignores a count. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Whether a file with this beginning is Collada, which is XML.
bool isCollada(const QByteArray& begin);
// Throws Error if the file is not well-formed XML or declares more values than it can hold. Throws
// for indices that are not numbers or are negative; −1 is allowed where the format gives it a
// meaning. Throws for an accessor that reads past the end of its array, for fans of triangles,
// for images without a file name, and for transforms that would change the shape.
void checkCollada(const ModelSource& source);

} // namespace dipwright
