// Warns the user about parts of a job's model, and about marks that do not fit it.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"

#include <QString>
#include <QStringList>

namespace dipwright {

struct Project;

// Returns a warning if parts of the model are too thin for the distance field; otherwise empty.
// `mesh` is the project's mesh in any pose; `query` belongs to `mesh`.
QString thinPartNote(const Project& project, const TriangleMesh& mesh, const SurfaceQuery& query);

// Returns a warning for each name of a material or CAD face that a zone, a mask or a layer of the
// artwork uses, but that the model lacks.
QStringList missingMaterialNotes(const Project& project);

// Returns warnings of zones, masks and marks for the seam that lie farther from the part than
// their radius and 1 mm, and of layers of which a part is lost (cutOffWarnings()). Such marks
// were perhaps made for another model: they mark the nearest surface, or nothing. `query` belongs
// to the project's mesh, moved by `modelToPose`.
QStringList misplacedNotes(const Project& project, const SurfaceQuery& query,
                           const Eigen::Isometry3d& modelToPose = Eigen::Isometry3d::Identity());

// Tells whether parts of the model face inwards. The import turns such parts, but older projects
// may still contain them. Takes seconds for models with many open parts.
bool isInsideOut(const TexturedMesh& model);
// Returns the warning for such a model.
QString insideOutNote();

} // namespace dipwright
