// 3MF packages. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "model/ModelSource.h"

namespace dipwright {

// Reads what the build of a 3MF package places: meshes, components (of other parts of the package
// too), base materials, colour groups and textures, in millimetres. Supports are left out; a
// triangle of several colours takes its first corner's. Assimp is not used for it because it mixes
// up texture coordinates and ends the program at damaged packages. Throws Error.
TexturedMesh readThreeMf(const QByteArray& bytes, const ModelSource& source, QStringList& warnings,
                         const CancelSwitch& cancelSwitch);

} // namespace dipwright
