// Computes drafts of a job: the same steps with a coarser film and smaller pictures, fast enough to
// follow the user's hand.
//
// Level n has film cells 2ⁿ times as long as the project's. Level 0 is the job itself (runJob()),
// but without refined films. Refined films (FilmRefinement.h) follow as the level `refinedLevel`.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

#include <map>
#include <optional>

namespace dipwright {

// The coarsest draft has at least this many cells along the longer edge of each film.
inline constexpr int fewestDraftCells = 20;

inline constexpr int refinedLevel = -1;

// Keeps the latest result of each level, so that the next run can reuse the parts that are still
// valid.
class JobDrafts {
public:
    void clear() { results_.clear(); }
    // Ignores null. A refined result takes the place of level 0.
    void add(int level, std::shared_ptr<const JobResult> result);
    // Returns a result that a run of `project` at `level` can reuse (`previous` of runJob()); null
    // if there is none. It has the results of `level`, and those results of other levels that do
    // not depend on the level, such as bodies in their poses.
    std::shared_ptr<const JobResult> reusable(const Project& project, int level) const;

private:
    std::map<int, std::shared_ptr<const JobResult>> results_;
    int newest_ = 0;
};

// Returns the level of the coarsest draft of `project`; 0 if its film is coarse already. The
// project must have a model. If `earlier` contains the prepared model, it is used.
int coarsestDraft(const Project& project, const JobDrafts& earlier);

// Runs the job at `level`; `coarsest` is the coarsest level. Reuses results of `earlier`. A draft
// estimates no numerical error and no read-back error. `observer` (JobOptions.h) receives the dips
// of other levels. Throws like runJob().
JobResult runLevel(const Project& project, int level, int coarsest, const SolverRegistry& registry,
                   const JobDrafts& earlier, const Progress& progress,
                   decltype(JobOptions::observer) observer = {});

// Whether the level refinedLevel has something to do after `result` of level 0.
bool canBeRefined(const JobResult& result);

// Returns how far 95 % of the sheets' points move from the draft `coarser` to `result`, whose cells
// are half as long, in mm; the largest of all dips. For an error of first order, this is the error
// of `result`. None if the films paint no common place.
std::optional<double> movesSince(const JobResult& coarser, const JobResult& result);

} // namespace dipwright
