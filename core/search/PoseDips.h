// Dips of many poses in batches. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "dip/FilledField.h"
#include "search/JudgedPose.h"
#include "search/SearchSubject.h"

#include <functional>
#include <limits>
#include <span>

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

    // Puts the dips in the places of their immersions in `judged`, which is as long and keeps what
    // was done where an exception ends it; `batchDone` is told after each batch how many that are.
    // Alike films are dipped together, whatever the order. A dip that fails to meet the film or
    // becomes unstable has no samples. Throws Error where the solver fails, Cancelled.
    void dip(const std::vector<Immersion>& immersions,
             std::vector<std::shared_ptr<const JudgedPose>>& judged,
             const std::function<void(std::size_t)>& batchDone) const;

private:
    bool choosesFilms() const;
    Eigen::AlignedBox2d fineCellsOf(const PosedBody& body) const;
    std::vector<std::size_t> alikeTogether(const std::vector<Immersion>& immersions) const;
    solver::DipSetup setupOf(const PosedBody& body, const FilledField& field,
                             const Immersion& immersion) const;
    void dipBatch(const std::vector<Immersion>& immersions, std::span<const std::size_t> batch,
                  std::vector<std::shared_ptr<const JudgedPose>>& judged) const;

    const SearchSubject& subject_;
    const JudgedBody& body_;
    const solver::SolverModule& module_;
    const CancelToken cancelToken_;
    const bool isJobs_; // the film is the job's
    FilmSettings film_;
    ProcessSettings process_;
    std::shared_ptr<const DistanceField> field_;
};

} // namespace dipwright
