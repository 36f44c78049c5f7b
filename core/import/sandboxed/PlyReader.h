// Polygon files. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/ModelSource.h"

namespace dipwright {

// Reads PLY 1.0, ASCII or binary of either byte order: vertices with x, y, z and texture
// coordinates (s, t or u, v or texture_u, texture_v), faces as lists of vertices (polygons are cut
// from their first corner), triangle strips (tristrips, as scans have them), texture coordinates a
// corner (texcoord), and pictures named by "comment TextureFile", chosen a face by texnumber. Lines
// may end by CR, LF or both; a byte order mark before the file is skipped. Refused are a second
// list of vertices, corners that are no whole numbers, and what stands after the last row: in
// ASCII, all but white space; in binary, as many bytes as further faces would have. Throws Error.
//
// Why a reader of our own: assimp 5.2.5 keeps one texture coordinate a vertex, so that at a seam,
// which scans store a corner (texcoord), the last face's overwrites the others'; of several
// pictures it keeps the last name and not which face has which; and it never returns from most
// files that end within their header. ImportModelTest has files of all three kinds.
TexturedMesh readPly(const ModelSource& source, QStringList& warnings,
                     const CancelToken& cancelToken);

} // namespace dipwright
