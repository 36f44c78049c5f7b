// Rewrites what poses a glTF model, its skins and morph target weights, so that assimp 5.2.5 reads
// it as meant. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

#include <QJsonObject>

namespace dipwright {

// Returns the document for assimp:
// - Skins without bind matrices, which glTF 2.0 allows ("Skins") but on which assimp crashes, have
//   them.
// - Weights of skins are floats. assimp takes integers for floats.
// - Each node has its own name, because assimp finds joints by their names.
// - Nodes do not share a mesh that has a skin or weights of morph targets, because assimp stores
//   these in the mesh. The weights of a node are written into its mesh.
// Without skins and weights of nodes, the document stays as it is. `binary` is the first buffer of
// a binary file. All skins that nodes use must exist.
QJsonObject gltfPoseForAssimp(const QJsonObject& document, const QByteArray& binary,
                              const ModelSource& source);

} // namespace dipwright
