// Computes the tolerances of a document's job in the background, for the project as it is when
// start() is called.
#pragma once

#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

struct ToleranceResult {
    std::shared_ptr<const JobResult> job; // has only dips and sheets
    std::shared_ptr<const JobTolerances> tolerances;
};

class ToleranceCheck : public QObject {
    Q_OBJECT

public:
    ToleranceCheck(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                   QObject* parent = nullptr);

    // First runs the dips that are out of date or have no result.
    void start(const Document& document);
    void cancel(); // cancels the check, so that a dip need not wait for it

signals:
    void done(const dipwright::ToleranceResult& result);

private:
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    CancelToken last_;
};

} // namespace dipwright
