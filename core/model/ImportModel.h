// Reading textured models from files (assimp) and putting them right, or refusing them.
#pragma once

#include "base/Progress.h"
#include "base/Units.h"
#include "model/TexturedMesh.h"

#include <QByteArray>
#include <QStringList>
#include <optional>

namespace dipwright {

struct ImportOptions {
    std::optional<Millimetres> longestEdge; // scale so that the bounding box's longest edge is this
    double unitMillimetres = 1;             // else: one unit of the file in mm
    QString texture;                        // a picture that replaces the model's own, or empty
};

// What was found, put right, or is still wrong, in sentences for the user.
struct ImportReport {
    std::size_t triangles = 0;
    bool closed = false;
    double volume = 0; // mm³
    BoundingBox box;
    QStringList repairs;  // "Removed 12 triangles without area"
    QStringList warnings; // "The mesh is not closed: …"
};

struct ImportedModel {
    TexturedMesh model;
    ImportReport report;
};

// Reads `path` (OBJ+MTL, PLY, STL, glTF/GLB, 3MF and what else assimp knows) with textures beside
// it or embedded. Repairs: duplicate positions welded, degenerate triangles dropped, unset normals
// recomputed, turned triangles and inside-out closed parts turned back. Refuses with Error:
// unreadable, no triangles, coordinates that are not finite, no extent, textures over 32,768 pixels
// a side or unreadable.
ImportedModel importModel(const QString& path, const ImportOptions& options,
                          const Progress& progress);

// The model with the picture of a file in place of all its own. Throws Error where the picture
// cannot be read or the model has no texture coordinates.
TexturedMesh withTexture(const TexturedMesh& model, const QString& path);

// The file filters of the formats, for dialogs: "*.obj" …
QStringList modelFilePatterns();

// The model as one self-contained file for a project's assets (binary glTF or the like, textures
// as PNG inside or returned beside), lossless in positions to float, texture coordinates, charts
// and pictures; readModel(writeModel(m)) equals m.
QByteArray writeModel(const TexturedMesh& model);
TexturedMesh readModel(const QByteArray& bytes, const QString& where);

} // namespace dipwright
