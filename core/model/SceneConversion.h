// From what assimp read to a textured mesh, not yet repaired. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "model/ModelFolder.h"
#include "model/TexturedMesh.h"

#include <QStringList>

struct aiScene;

namespace dipwright {

struct SceneConversion {
    const aiScene& scene;
    QString path;               // of the model file, for messages
    const ModelFolder& folder;  // where its pictures are
    QImage texture;             // in place of the model's own, or null
    bool linearColours = false; // material colours are linear light (glTF), not sRGB
};

// All triangles of the scene, its nodes' transforms applied, in the file's units, with the
// materials they use. Adds to `warnings` what had to be left out. Throws Error where there is
// nothing to use.
TexturedMesh convertScene(const SceneConversion& conversion, QStringList& warnings,
                          const Progress& progress);

} // namespace dipwright
