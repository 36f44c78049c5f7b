// Warns the user about thin or inside-out parts of a job's model.
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

// Tells whether parts of the model face inwards. The import turns such parts, but older projects
// may still contain them. Takes seconds for models with many open parts.
bool isInsideOut(const TexturedMesh& model);
// Returns the warning for such a model.
QString insideOutNote();

} // namespace dipwright
