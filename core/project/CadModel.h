// Keeps a project's model in step with the CAD file from which it was made.
#pragma once

#include "base/Progress.h"
#include "base/Units.h"

#include <QString>

namespace dipwright {

struct ImportedModel;
struct Project;

// Takes the model of an import into the project, and what is known about its file: `path` and, for
// a CAD model, the file's content and unit, the scale, and the tolerance of the triangles.
void takeModel(Project& project, ImportedModel imported, const QString& path);

// Throws Error naming `where` unless a model comes from a CAD file, whose triangles can be made
// again with another tolerance.
void requireCad(bool isCad, const QString& where);

// Returns the model's triangles made again from the project's CAD file with another tolerance; 0:
// the usual one (usualTessellation()). The model keeps its size and place, so that marks and
// artwork stay where they are. Throws Error if the project has no CAD file, or as importModel().
ImportedModel retessellated(const Project& project, Millimetres tolerance,
                            const Progress& progress);

// Returns what is known about the CAD file of a project's model, as a sentence for the user: unit,
// number of faces, tolerance. Empty without a CAD file.
QString cadText(const Project& project);

} // namespace dipwright
