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
// The formats in the order in which they are listed. CAD formats are listed only if the program was
// built with DIPWRIGHT_CAD.
const std::vector<ModelFormat>& modelFormats();

// Whether a file's name is that of a CAD file (STEP, IGES), whether or not this program can read
// it.
bool isCadFile(const QString& path);

// Whether the format of a file, by its name, states the file's unit (Collada, FBX, 3MF, CAD). Such
// files are read in mm, so nobody needs to guess or choose the unit.
bool namesUnit(const QString& path);

// Returns the file filters for dialogs: "*.obj", "*.ply" …
QStringList modelFilePatterns();

// Returns all names as a list: "OBJ, PLY, STL".
QString modelFormatNames();
// Returns all names as a choice in the user's language: "OBJ, PLY or STL".
QString anyModelFormat();

} // namespace dipwright
