// Computes the numerical error of a document's sheets in the background, for the project as it is
// when start() is called.
#pragma once

#include "pipeline/SheetNumericalError.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

#include <QPointer>

namespace dipwright {

class NumericalErrorCheck : public QObject {
    Q_OBJECT

public:
    NumericalErrorCheck(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                        QObject* parent = nullptr);

    void start(const Document& document); // works even if no dip has been computed before
    void cancel();                        // cancels the check, so that a dip need not wait for it

signals:
    // `outdated`: the project has changed since start().
    void done(const std::vector<dipwright::DipNumericalError>& numericalError, bool outdated);

private:
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    CancelToken last_;
};

} // namespace dipwright
