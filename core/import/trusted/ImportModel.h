// Reading textured models from files and putting them right, or refusing them.
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "base/Units.h"
#include "model/TexturedMesh.h"

#include <QStringList>
#include <optional>

namespace dipwright {

struct ImportOptions {
    std::optional<Millimetres> longestEdge; // scale so that the bounding box's longest edge is this
    double unitMillimetres = 1;             // else: one unit of the file in mm
    QString texture;                        // a picture that replaces the model's own, or empty
    // Files outside the model's folder that are read all the same: all, or these, absolute.
    bool allowOutside = false;
    QStringList outsideFiles;
};

// mm in a unit of a model's file: of the usual ones, millimetres first, the one in which the
// longest edge, so many units long, is as long as what is mostly dipped; 1 where none is.
double guessedUnit(double longestEdge);

// Thrown where a model names files that are there but do not belong to its folder: they lie outside
// of it, by a link too, or are hidden. They have not been read.
class OutsideFiles : public Error {
public:
    OutsideFiles(const QStringList& files, const QString& model);
    const QStringList& files() const { return files_; } // absolute

private:
    QStringList files_;
};

// What was found, put right, or is still wrong, in sentences for the user.
struct ImportReport {
    std::size_t triangles = 0;
    bool closed = false;
    double volume = 0; // mm³
    BoundingBox box;
    QStringList repairs;  // "Removed 12 triangles without area"
    QStringList warnings; // "The mesh is not closed: …"

    // Both in a line, for ModelOrigin::remarks.
    QString remarks() const { return (warnings + repairs).join(QStringLiteral("; ")); }
};

struct ImportedModel {
    TexturedMesh model;
    ImportReport report;
};

// Reads `path`, of one of modelFormats(), with textures beside it or embedded. Repairs: duplicate
// positions welded, degenerate triangles dropped, unset normals recomputed, turned triangles and
// inside-out closed parts turned back. Refuses with Error: unreadable, no triangles, coordinates
// that are not finite, no extent, textures that are unreadable, or more than Budgets.h allows; with
// OutsideFiles unless these are allowed.
ImportedModel importModel(const QString& path, const ImportOptions& options,
                          const Progress& progress);

// The model with the picture of a file in place of all its own. Throws Error where the picture
// cannot be read or the model has no texture coordinates.
TexturedMesh withTexture(const TexturedMesh& model, const QString& path);

} // namespace dipwright
