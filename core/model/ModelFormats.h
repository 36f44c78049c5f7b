// The formats of models that are read, all of them: texts and dialogs name these. Reentrant.
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

// The file filters for dialogs: "*.obj", "*.ply" …
QStringList modelFilePatterns();

// "OBJ, PLY, STL", all of them.
QString modelFormatNames();
// "OBJ, PLY or STL", all of them, in the user's language.
QString anyModelFormat();

} // namespace dipwright
