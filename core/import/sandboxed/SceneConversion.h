// Converts a scene that assimp has read to a textured mesh, without repairs. Private to this
// folder.
#pragma once

#include "base/Progress.h"
#include "import/sandboxed/MaterialFileCheck.h"
#include "import/sandboxed/ModelSource.h"

struct aiScene;

namespace dipwright {

// Facts that the scene itself does not contain.
struct SceneMeaning {
    // Material colours are linear light, not sRGB, and a skin moves all points of its mesh.
    bool isGltf = false;
    PicturePlacements placements;
    // Turns the scene's coordinates into the model's coordinates: mm, with Y up, if the file states
    // its unit and axes.
    Eigen::Matrix3f frame = Eigen::Matrix3f::Identity();
    // Whether the file has a texture that is mirrored or ends at its edge, which assimp does not
    // report.
    bool hasTextureThatEnds = false;
};

// Returns all triangles of the scene, with the transforms of its nodes, its skins and the
// placements of its pictures applied. Adds what was left out to `warnings`. Throws Error.
TexturedMesh convertScene(const aiScene& scene, const ModelSource& source,
                          const SceneMeaning& meaning, QStringList& warnings,
                          const Progress& progress);

} // namespace dipwright
