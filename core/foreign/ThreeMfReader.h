// 3MF packages. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "foreign/ModelSource.h"

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
// lib3mf 1.8.1 reads all of this, and survived those packages; but its time to read doubles with
// every object that places the one before twice, so that a file of a few kilobytes can keep it for
// hours, where this reader counts first; its interface is gone from the 2.x that other systems
// have; and the units, supports and materials would still be ours to apply.
TexturedMesh readThreeMf(const ModelSource& source, QStringList& warnings,
                         const CancelSwitch& cancelSwitch);

} // namespace dipwright
