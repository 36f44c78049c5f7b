// Prepares the pose search of a project.
#pragma once

#include "search/PoseSearch.h"

namespace dipwright {

struct Project;

// Returns the project's data for a pose search with the solver of this id. Throws Error if the
// project has no model.
SearchSubject searchSubject(const Project& project, const QString& solver);

} // namespace dipwright
