// The formats of models that are read for certain, and that texts and dialogs name; assimp reads
// others too. Reentrant.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace dipwright {

struct ModelFormat {
    QString name;         // "glTF"
    QStringList suffixes; // of its files, in lower case: "gltf", "glb"
};
// In the order in which they are named.
const std::vector<ModelFormat>& modelFormats();

// "OBJ, PLY, STL", all of them, for a list that goes on.
QString modelFormatNames();
// "OBJ, PLY or STL", all of them, in the user's language.
QString anyModelFormat();

} // namespace dipwright
