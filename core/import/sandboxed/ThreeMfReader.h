// Reads 3MF packages. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Reads the objects that the build of a 3MF package places: meshes, components (also of other parts
// of the package), base materials, colour groups and textures. The result is in millimetres.
// Supports are left out. A triangle with several colours takes the colour of its first corner.
// Refuses what would be misread: an unknown unit, an unknown required extension, a transform
// without twelve numbers, a duplicate ID, and a missing material or texture. Throws Error.
//
// Neither of the known libraries is used. assimp 5.2.5 takes texture coordinates in the order of
// the points, not by their index. It does not read pictures, and ignores the unit and the parts
// that components name. It crashed on one of 400 packages in which three bytes had been changed.
// lib3mf 1.8.1 is faster, but drops colours that come after the objects that use them. It refuses
// white space that is written as character references, and accepts packages whose materials and
// units do not exist. If every object places the previous one twice, its run time doubles with each
// object; this reader counts the triangles first and refuses too many. Version 2.x, which other
// systems have, no longer has this interface.
TexturedMesh readThreeMf(const ModelSource& source, QStringList& warnings,
                         const CancelToken& cancelToken);

} // namespace dipwright
