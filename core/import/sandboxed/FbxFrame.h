// Says how an FBX file's coordinates lie in the frame of this program. Private to this folder.
#pragma once

#include "import/sandboxed/ModelSource.h"

#include <Eigen/Core>

struct aiScene;

namespace dipwright {

// Returns the matrix from the scene's coordinates to mm, with X to the right, Y up and Z to the
// viewer. Follows the file's GlobalSettings (FBX SDK, FbxAxisSystem and FbxSystemUnit), which
// assimp 5.2.5 only passes on. A file without them is in centimetres, with Y up. Throws Error if
// the axes or the unit are impossible.
Eigen::Matrix3f fbxFrame(const aiScene& scene, const ModelSource& source);

} // namespace dipwright
