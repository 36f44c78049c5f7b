// Dips of many poses in batches. Private to this folder.
#pragma once

#include "search/JudgedPose.h"
#include "search/SearchSubject.h"

#include <functional>
#include <limits>

namespace dipwright {

// How finely a pose is dipped; never finer than the job is.
struct DipDetail {
    double cells;  // of the film, along the longest edge of the body's box
    int field;     // cells of the distance field along that edge
    double travel; // cells that the contact line travels in one step, at least
};
// Enough to tell poses that are worth refining; to rank those; and as the job is.
inline constexpr DipDetail coarseDetail{20, 128, 0.5}, finerDetail{40, 128, 0.5},
    jobDetail{std::numeric_limits<double>::infinity(), std::numeric_limits<int>::max(), 0};

class PoseDips {
public:
    PoseDips(const SearchSubject& subject, const JudgedBody& body,
             const solver::SolverModule& module, const DipDetail& detail, const Progress& progress);

    // `batchDone` is told how many are done after each batch. A dip that fails to meet the film or
    // becomes unstable has no samples. Throws Error where the solver fails, Cancelled.
    std::vector<std::shared_ptr<const JudgedPose>>
    dip(const std::vector<Immersion>& immersions,
        const std::function<void(std::size_t)>& batchDone) const;

private:
    solver::DipSetup setupOf(const PosedBody& body, const Immersion& immersion) const;
    void dipBatch(const std::vector<Immersion>& immersions, std::size_t begin, std::size_t end,
                  std::vector<std::shared_ptr<const JudgedPose>>& judged) const;

    const SearchSubject& subject_;
    const JudgedBody& body_;
    const solver::SolverModule& module_;
    const CancelSwitch cancelSwitch_;
    const bool isJobs_; // the film is the job's
    FilmSettings film_;
    ProcessSettings process_;
    std::shared_ptr<const DistanceField> field_;
};

} // namespace dipwright
