#include "workbench/accuracy/ToleranceCheck.h"

#include "pipeline/JobTolerances.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SameSheets.h"
#include "workbench/jobs/StartJob.h"

namespace dipwright {
namespace {

constexpr double dipped = 0.1; // progress of the job when all dips are done

} // namespace

ToleranceCheck::ToleranceCheck(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                               QObject* parent)
    : QObject(parent), jobs_(jobs), registry_(registry), messages_(messages) {}

void ToleranceCheck::start(const Document& document) {
    last_ = startJob(
        jobs_, messages_, tr("Computing the tolerances"), tr("Tolerances"),
        [project = document.project(), earlier = document.result(),
         &registry = registry_](const Progress& progress) {
            JobOptions options;
            options.estimatesNumericalError = false;
            options.refines = !(earlier && makeSameSheets(earlier->project, project)); // as shown
            ToleranceResult told;
            told.job = std::make_shared<const JobResult>(
                runJob(project, registry, options, earlier.get(), progress.part(0, dipped)));
            told.tolerances = std::make_shared<const JobTolerances>(
                jobTolerances(*told.job, project.tolerance, registry, progress.part(dipped, 1)));
            return told;
        },
        [this](const ToleranceResult& told) { emit done(told); });
}

void ToleranceCheck::cancel() {
    last_.cancel();
}

} // namespace dipwright
