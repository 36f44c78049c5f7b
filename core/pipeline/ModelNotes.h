// What is to be said of a job's model, whatever is done with it.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"

#include <QStringList>

namespace dipwright {

struct Project;

// In sentences: what was put right when it was imported, and parts too thin for the distance field.
// `mesh`: the project's, in any pose; `query`: of that.
QStringList modelNotes(const Project& project, const TriangleMesh& mesh, const SurfaceQuery& query);

// Whether parts of the model face inwards, which an import turns; projects from before may have
// such. Takes seconds for models of many open parts.
bool isInsideOut(const TexturedMesh& model);
QString insideOutNote();

} // namespace dipwright
