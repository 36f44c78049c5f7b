// What is to be said of a job's model, whatever is done with it.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"

#include <QString>

namespace dipwright {

struct Project;

// That parts of it are too thin for the distance field; empty where none are. `mesh`: the
// project's, in any pose; `query`: of that.
QString thinPartNote(const Project& project, const TriangleMesh& mesh, const SurfaceQuery& query);

// Whether parts of the model face inwards, which an import turns; projects from before may have
// such. Takes seconds for models of many open parts.
bool isInsideOut(const TexturedMesh& model);
QString insideOutNote();

} // namespace dipwright
