// Finds out which texture coordinates the textures of a Collada file use, and whether they repeat.
// Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Returns the file for assimp. In it, the symbol with which a texture names its texture coordinates
// contains their index among the sets of each geometry. assimp 5.2.5 takes the first number in the
// symbol for this index and ignores the bindings (COLLADA 1.4.1, <bind_vertex_input>). Leaves a
// symbol unchanged if the file does not say clearly which set it means, and warns of it if a
// geometry has several sets. Damaged XML is left to checkCollada().
QByteArray withTextureSets(const ModelSource& source, QStringList& warnings);

// Whether a sampler of the file mirrors its texture or ends it at its edge (COLLADA 1.4.1, wrap_s
// and wrap_t), which assimp 5.2.5 does not read. Does not find out which texture this concerns.
bool hasTextureThatEnds(const QByteArray& file);

} // namespace dipwright
