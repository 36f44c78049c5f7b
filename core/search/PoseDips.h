// Dips of many poses in batches. Private to this folder.
#pragma once

#include "search/JudgedPose.h"
#include "search/SearchSubject.h"

#include <functional>

namespace dipwright {

class PoseDips {
public:
    // With the film of the job, or with one as coarse as poses can be ranked by.
    enum class Film { Coarse, Own };
    PoseDips(const SearchSubject& subject, const JudgedBody& body,
             const solver::SolverModule& module, Film film, const Progress& progress);

    // `batchDone` is told how many are done after each batch. A dip that fails to meet the film or
    // becomes unstable has no samples. Throws Error where the solver fails, Cancelled.
    std::vector<std::shared_ptr<const JudgedPose>>
    dip(const std::vector<Immersion>& immersions,
        const std::function<void(std::size_t)>& batchDone) const;

private:
    void dipBatch(const std::vector<Immersion>& immersions, std::size_t begin, std::size_t end,
                  std::vector<std::shared_ptr<const JudgedPose>>& judged) const;

    const SearchSubject& subject_;
    const JudgedBody& body_;
    const solver::SolverModule& module_;
    const CancelSwitch cancelSwitch_;
    FilmSettings film_;
    ProcessSettings process_;
    std::shared_ptr<const DistanceField> field_;
};

} // namespace dipwright
