// Damage to Collada files (.dae) at which assimp 5.2.5 reads something else without a word: it
// reads past the end of an array, takes an index below 0 for 0, and ignores a count. Private to
// this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Whether a file that begins like this is Collada, which is XML.
bool isCollada(const QByteArray& begin);
// Throws Error where the file is not well-formed, counts more than it can hold, has indices that
// are no numbers or, where no −1 is meant, below 0, or an accessor that reads past the end of its
// array.
void checkCollada(const ModelSource& source);

} // namespace dipwright
