#include "workbench/dip/DeeperFilm.h"

#include "pipeline/DeeperDip.h"
#include "workbench/jobs/StartJob.h"

namespace dipwright {

DeeperFilm::DeeperFilm(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                       QObject* parent)
    : QObject(parent), jobs_(jobs), registry_(registry), messages_(messages) {}

void DeeperFilm::start(const std::shared_ptr<const JobResult>& result) {
    if (asked_.lock() == result && !last_.isCancelled()) {
        return;
    }
    last_.cancel();
    asked_ = result;
    last_ = startJob(
        jobs_, messages_, tr("Simulating a deeper dip"), tr("Deeper dip"),
        [result, &registry = registry_](const Progress& progress) {
            return deeperDip(*result, result->immersions.size() - 1, registry, progress);
        },
        [this, result](const std::shared_ptr<const LaidFilm>& film) { emit done(result, film); });
}

void DeeperFilm::cancel() {
    last_.cancel();
}

} // namespace dipwright
