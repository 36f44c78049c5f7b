// Prepares the pose search of a project, and takes over the dips that it simulated.
#pragma once

#include "pipeline/JobResult.h"
#include "search/PoseSearch.h"

namespace dipwright {

// Returns the project's data for a pose search with the solver of this id. Throws Error if the
// project has no model.
SearchSubject searchSubject(const Project& project, const QString& solver);

// Tells whether searchSubject() has the same data of both projects, apart from their names and
// poses. Models are equal only if they are the same object.
bool haveSameSearchSubject(const Project& first, const Project& second);

// Returns a result that can be passed to runJob() as `previous`: the dips of `poses`, as a search
// of `project` with this solver simulated them. Contains only the films, laid on the body, and
// their numerical errors. Null unless `poses` have the films of all their dips.
std::shared_ptr<const JobResult> foundDips(Project project, const RankedPoses& poses,
                                           const SolverInfo& solver);

} // namespace dipwright
