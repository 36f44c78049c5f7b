// The pose search of a job.
#pragma once

#include "search/PoseSearch.h"

namespace dipwright {

struct Project;

// What is searched for, of a project, by the solver of this id. Throws Error where it has no model.
SearchSubject searchSubject(const Project& project, const QString& solver);

} // namespace dipwright
