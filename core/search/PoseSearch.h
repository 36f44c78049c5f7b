// Searches for the best poses (docs/pose-search.md). The search rates thousands of poses by the
// body's shape and dips the best of them with a coarse film. It then refines the best results and
// dips them as the job would.
#pragma once

#include "accuracy/verdict/Verdict.h"
#include "base/Progress.h"
#include "search/JobFilms.h"
#include "search/SearchShard.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

#include <Eigen/Core>
#include <QStringList>
#include <chrono>
#include <functional>

namespace dipwright {

// One pose or a pair of poses that the search found.
struct RankedPoses {
    std::vector<Immersion> immersions;
    double objective = 0;    // 0 … 1
    double limitsMissed = 0; // 0 if all limits are kept
    // Sentences on the limits of the tank that the dips exceed, each with the dip's number if there
    // are two; empty if the tank can carry them out.
    QStringList tankFaults;
    PoseMeasures measures;
    bool isConfirmed = false;      // dipped with the job's own film
    bool areOwn = false;           // the job's own poses, which take part in the ranking
    std::vector<Verdict> verdicts; // on each dip; empty if not confirmed
    Verdict together;              // on all dips together: what none of them paints
    // One for each dip; null if that dip failed. Only confirmed poses in the first three ranks keep
    // their films; for all others this is empty.
    std::vector<std::shared_ptr<const JobFilms>> films;

    // Returns the worst of the verdicts on the dips alone.
    Advice adviceOnDips() const;
    // Returns the worst of all verdicts, also of the one on all dips together.
    Advice advice() const;
};

// A direction of the model that pointed down in a pose that the search tried.
struct TriedDirection {
    Eigen::Vector3d down; // unit length, model coordinates
    double coverage = 0;  // previewed share of the surface
    // Best objective with this or a similar direction; none if no such direction was simulated.
    std::optional<double> objective;
};

// The result of a search.
struct SearchResult {
    // The best first; never empty. Poses that the tank cannot carry out come after all others; of
    // the rest, poses whose sheets must not be printed, or are predicted so, come last. Of these
    // and of the others, pairs of which one dip paints hardly anything come last.
    std::vector<RankedPoses> ranking;
    std::optional<RankedPoses> current; // the job's own poses; none if they cannot be dipped
    std::vector<TriedDirection> directions;
    double equator = 0;     // mm, see objective()
    bool isComplete = true; // false if cancelled; the ranking then holds the best so far
};

// A measure in which two results differ.
struct MeasureDifference {
    Measure measure;
    // Value in the first result minus the value in the second.
    double more = 0;
    bool isBetter = false;
};
// Returns the measures in which `poses` differ visibly (in measureText()) from `others`, the most
// important for the objective first.
std::vector<MeasureDifference> differences(const RankedPoses& poses, const RankedPoses& others,
                                           const SearchSettings& settings, double equator);
// Returns a text for the user, such as "Coverage −3.0 %".
QString changeText(const MeasureDifference& difference);
// Returns a text for the user, such as "Coverage −3.0 % (worse), Largest stretch −0.40 (better)";
// "no difference" if there is none.
QString reasonText(const std::vector<MeasureDifference>& differences);

// The state of a running search.
struct SearchState {
    int done = 0, wanted = 0;          // numbers of dips
    std::optional<double> secondsLeft; // none if not known yet
    bool isRefiningFilm = false;       // the best pose is dipped with smaller cells
    const SearchResult& soFar;         // ranking of the dips done
};
// Called from the working thread between batches of dips. If it blocks, the search waits. Returns
// how long it waited; the search does not count this time as its own.
using SearchWatch = std::function<std::chrono::duration<double>(const SearchState&)>;

// Runs the search on `module` in batches. Deterministic except for SearchState::secondsLeft: the
// same subject, settings and module give bitwise equal results for any number of threads. `parts`
// holds all shards of this search, whose dips other processes simulated (SearchShard.h), or is
// empty. If cancelled, returns the ranking so far; throws Cancelled if there is none. Throws Error
// if a setting is out of range, a shard belongs to another search, no pose paints anything, or the
// solver fails.
SearchResult searchPoses(const SearchSubject& subject, const SearchSettings& settings,
                         const solver::SolverModule& module, const std::vector<SearchShard>& parts,
                         const SearchWatch& watch, const Progress& progress);

} // namespace dipwright
