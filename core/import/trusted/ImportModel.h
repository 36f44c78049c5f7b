// Imports textured models from files: reads, repairs or refuses them.
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "base/Units.h"
#include "import/trusted/CadFacts.h"
#include "model/MeshRepair.h"
#include "model/TexturedMesh.h"

#include <QStringList>
#include <optional>

namespace dipwright {

struct ImportOptions {
    // If set, the bounding box's longest edge is scaled to this.
    std::optional<Millimetres> longestEdge;
    // Size of the file's unit in mm; used if longestEdge is not set. For a file that names its unit
    // (namesUnit()) it is a factor.
    double unitMillimetres = 1;
    QString texture; // path of a picture that replaces the model's own, or empty
    // For a CAD file: largest distance of the triangles from the surfaces, on the scaled model. 0:
    // usualTessellation(). unitMillimetres is then the scale, because CAD files name their unit.
    Millimetres tessellation{0};
    // Whether all files outside the model's folder may be read.
    bool allowOutside = false;
    // Absolute paths of the files outside the folder that may be read.
    QStringList outsideFiles;
};

// Guesses the unit of a model's file, in mm. Tries the usual units, beginning with millimetres.
// Returns the first unit in which `longestEdge` has the size of a typical part, or 1 if there is
// none.
double guessedUnit(double longestEdge);

// Thrown if a model names existing files that do not belong to its folder. They are outside it,
// possibly through a link, or hidden. They have not been read.
class OutsideFiles : public Error {
public:
    OutsideFiles(const QStringList& files, const QString& model);
    const QStringList& files() const { return files_; } // absolute

private:
    QStringList files_;
};

// What was found, repaired or is still wrong, in sentences for the user.
struct ImportReport {
    std::size_t triangles = 0;
    bool closed = false;
    double volume = 0; // mm³
    BoundingBox box;
    ModelRepairs repaired;
    // The repairs as sentences, such as "Triangles without area that were removed: 12".
    QStringList repairs;
    QStringList warnings; // such as "The mesh is not closed: …"; begin with the losses
    // What was left out, or cannot be shown as the file means it.
    QStringList losses;
    std::optional<CadFacts> cad; // of a CAD file
    double unitMillimetres = 1;  // factor by which the file's lengths were multiplied

    // Returns all but the losses in one line, for ModelOrigin::remarks.
    QString remarks() const {
        return (warnings.mid(losses.size()) + repairs).join(QStringLiteral("; "));
    }
};

struct ImportedModel {
    TexturedMesh model;
    ImportReport report;
    QByteArray cadFile; // content of a CAD file; otherwise empty
};

// Imports the model file `path`, in one of modelFormats(), with textures beside it or embedded.
// Repairs the model: welds duplicate positions, closes cracks that rounding has opened, removes
// degenerate and duplicate triangles. Recomputes unset normals, and turns reversed triangles and
// inside-out parts.
// Throws Error if the model or its textures are unreadable, or if the model exceeds Budgets.h.
// Throws Error if the model has no triangles, no extent, coordinates that are not finite, or points
// that lie absurdly far from most others. Throws OutsideFiles if the model names files outside its
// folder that are not allowed.
ImportedModel importModel(const QString& path, const ImportOptions& options,
                          const Progress& progress);

// Imports a CAD file from its content, as importModel(). `name` is its name, also for messages.
ImportedModel importCad(const QString& name, const QByteArray& content,
                        const ImportOptions& options, const Progress& progress);

// Returns the model with all its pictures replaced by the picture of a file. Throws Error if the
// picture cannot be read or the model has no texture coordinates.
TexturedMesh withTexture(const TexturedMesh& model, const QString& path);

} // namespace dipwright
