// Prepares OBJ files for assimp. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the text of an OBJ file as assimp 5.2.5 reads it correctly: without a byte order mark,
// blanks before keywords, and comments, and with a digit before each decimal point. assimp would
// leave out such lines, and faces would then name other points. Texture coordinates that are not
// numbers are too large in the result, so that they are reported; assimp would read them as 0.
// Numbers with more than 19 digits before the decimal point, which assimp reads as 0, have an
// exponent.
// Throws Error if a point has too few or too many numbers, or a weight other than 1.
QByteArray objForAssimp(const ModelSource& source);

} // namespace dipwright
