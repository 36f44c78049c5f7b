// All model formats that the program reads. Messages and dialogs take their names from here.
// Reentrant.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace dipwright {

struct ModelFormat {
    QString name;         // "glTF"
    QStringList suffixes; // file suffixes in lower case: "gltf", "glb"
};
// The formats in the order in which they are listed.
const std::vector<ModelFormat>& modelFormats();

// Returns the file filters for dialogs: "*.obj", "*.ply" …
QStringList modelFilePatterns();

// Returns all names as a list: "OBJ, PLY, STL".
QString modelFormatNames();
// Returns all names as a choice in the user's language: "OBJ, PLY or STL".
QString anyModelFormat();

} // namespace dipwright
