// Polygon files. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "model/ModelSource.h"

namespace dipwright {

// Reads PLY 1.0, ASCII or binary of either byte order: vertices with x, y, z and texture
// coordinates (s, t or u, v or texture_u, texture_v), faces as lists of vertices (polygons are cut
// from their first corner), texture coordinates a corner (texcoord), and pictures named by "comment
// TextureFile", chosen a face by texnumber. Assimp is not used for it because it never returns from
// files that end within their header. Throws Error.
TexturedMesh readPly(const QByteArray& bytes, const ModelSource& source, QStringList& warnings,
                     const CancelSwitch& cancelSwitch);

} // namespace dipwright
