#include "workbench/accuracy/NumericalErrorCheck.h"

#include "workbench/jobs/StartJob.h"

namespace dipwright {

NumericalErrorCheck::NumericalErrorCheck(JobRunner& jobs, const SolverRegistry& registry,
                                         Messages& messages, QObject* parent)
    : QObject(parent), jobs_(jobs), registry_(registry), messages_(messages) {}

void NumericalErrorCheck::start(const Document& document) {
    const Project project = document.project();
    last_ = startJob(
        jobs_, messages_, tr("Checking the numerical error"), tr("Check numerical error"),
        [project, known = document.result(), &registry = registry_](const Progress& progress) {
            return sheetNumericalError(project, registry, progress, known.get());
        },
        [this, project, now = QPointer<const Document>(&document)](
            const std::vector<DipNumericalError>& numericalError) {
            emit done(numericalError, !now || now->project() != project);
        });
}

void NumericalErrorCheck::cancel() {
    last_.cancel();
}

} // namespace dipwright
