// The pose search of a job.
#pragma once

#include "project/Project.h"
#include "search/PoseSearch.h"

namespace dipwright {

// What is searched for, of a project. Throws Error where it has no model.
SearchSubject searchSubject(const Project& project);

} // namespace dipwright
