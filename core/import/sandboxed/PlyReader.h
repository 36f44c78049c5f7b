// Reads PLY files. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Reads PLY 1.0, ASCII or binary of either byte order:
// - vertices with x, y, z and texture coordinates (s, t or u, v or texture_u, texture_v)
// - faces as lists of vertices; polygons are cut into a fan from their first corner, or by
//   PolygonTriangles.h if this would fold
// - triangle strips (tristrips), as scans have them
// - texture coordinates per corner (texcoord)
// - pictures named by "comment TextureFile" and chosen per face by texnumber
// Lines may end with CR, LF or both. A byte order mark before the file is skipped. Refuses a second
// list of vertices, and corners that are not integers. Refuses data after the last row: in ASCII
// anything but white space, in binary what could be further rows of faces. Throws Error.
//
// assimp 5.2.5 is not used, because it keeps one texture coordinate per vertex. Scans store the
// coordinates per corner (texcoord), so at a texture seam the last face overwrites the others. If
// there are several pictures, assimp keeps only the last name, without the choice per face. It also
// hangs on most files that end within their header. ImportModelTest has files of all three kinds.
TexturedMesh readPly(const ModelSource& source, QStringList& warnings,
                     const CancelToken& cancelToken);

} // namespace dipwright
