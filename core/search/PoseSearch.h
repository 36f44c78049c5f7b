// Which way round to dip: thousands of poses judged by the body's shape, the best of them dipped
// with a coarse film, the best of those refined and dipped as the job would be
// (docs/pose-search.md).
#pragma once

#include "base/Progress.h"
#include "search/SearchShard.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

#include <Eigen/Core>
#include <functional>

namespace dipwright {

// One immersion or a pair, as found.
struct RankedPoses {
    std::vector<Immersion> immersions;
    double objective = 0;    // 0 … 1
    double limitsMissed = 0; // 0: all limits are kept
    PoseMeasures measures;
    bool isConfirmed = false; // by dips with the job's own film
};

// A direction of the model that was tried as the one that goes down first.
struct TriedDirection {
    Eigen::Vector3d down;            // unit, model coordinates
    double coverage = 0;             // previewed, share of the surface
    std::optional<double> objective; // of the best found with it or with one like it; none: not
                                     // simulated
};

struct SearchResult {
    std::vector<RankedPoses> ranking;   // the best first; never empty
    std::optional<RankedPoses> current; // the job's own poses; none where they cannot be dipped
    std::vector<TriedDirection> directions;
    double equator = 0;     // mm, see objective()
    bool isComplete = true; // false: cancelled, the best so far
};

// A measure that differs, and by how much it is more.
struct MeasureDifference {
    Measure measure;
    double more = 0;
    bool isBetter = false;
};
// What tells poses from others: measures whose difference would be seen in measureText(), those
// that count most in the objective first.
std::vector<MeasureDifference> differences(const RankedPoses& poses, const RankedPoses& others,
                                           const SearchSettings& settings, double equator);
// For the user: "−3.0 % coverage, +0.40 largest stretch"; "the same" where there are none.
QString reasonText(const std::vector<MeasureDifference>& differences);

// What is known while a search goes on.
struct SearchState {
    int done = 0, wanted = 0;          // dips
    std::optional<double> secondsLeft; // none: cannot be told yet
    const SearchResult& soFar;         // ranked from what is done
};
// Called from the working thread, between batches of dips. May wait in it: so does the search.
using SearchWatch = std::function<void(const SearchState&)>;

// Runs on `module` in batches. Deterministic but for SearchState::secondsLeft: the same subject,
// settings and module give the same result bit for bit, for any number of threads. `parts`: all
// parts of this search, dipped elsewhere (SearchShard.h), or none. Cancelled, it returns what is
// ranked so far, where anything is. Throws Error (a setting out of range, parts that do not belong
// to the search, no pose paints anything, the solver fails) or Cancelled.
SearchResult searchPoses(const SearchSubject& subject, const SearchSettings& settings,
                         const solver::SolverModule& module, const std::vector<SearchShard>& parts,
                         const SearchWatch& watch, const Progress& progress);

} // namespace dipwright
