#include "workbench/accuracy/CertaintyCheck.h"

#include "workbench/jobs/StartJob.h"

namespace dipwright {

CertaintyCheck::CertaintyCheck(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                               QObject* parent)
    : QObject(parent), jobs_(jobs), registry_(registry), messages_(messages) {}

void CertaintyCheck::start(const Document& document) {
    const Project project = document.project();
    last_ = startJob(
        jobs_, messages_, tr("Checking the numerical error"), tr("Check numerical error"),
        [project, &registry = registry_](const Progress& progress) {
            return sheetCertainty(project, registry, progress);
        },
        [this, project, now = QPointer<const Document>(&document)](
            const std::vector<ImmersionCertainty>& certainty) {
            emit done(certainty, !now || now->project() != project);
        });
}

void CertaintyCheck::cancel() {
    last_.cancel();
}

} // namespace dipwright
