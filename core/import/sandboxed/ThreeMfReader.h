// 3MF packages. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Reads what the build of a 3MF package places: meshes, components (of other parts of the package
// too), base materials, colour groups and textures, in millimetres. Supports are left out; a
// triangle of several colours takes its first corner's. Refused are what would be read wrongly: a
// unit or a required extension that is not known here, a transform that is not twelve numbers, a
// number given twice, and a material or texture that is not there. Throws Error.
//
// Why a reader of our own: assimp 5.2.5 takes texture coordinates in the order of the points and
// not by their index, does not read the pictures, ignores the unit and the parts that components
// name, and ended the program at one of 400 packages in which three bytes had been changed.
// lib3mf 1.8.1 is faster, but drops colours that stand after what shows them, refuses white space
// as character references, and reads packages with materials and units that are not there; its time
// doubles with every object that places the one before twice, where this reader counts first; and
// its interface is gone from the 2.x that other systems have.
TexturedMesh readThreeMf(const ModelSource& source, QStringList& warnings,
                         const CancelToken& cancelToken);

} // namespace dipwright
