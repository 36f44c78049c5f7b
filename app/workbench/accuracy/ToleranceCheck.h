// How far the colours of a document's job may land off their places, computed on its project as it
// is when asked, run or not.
#pragma once

#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

// What was computed, of which job.
struct ToleranceResult {
    std::shared_ptr<const JobResult> job; // its dips and sheets only
    std::shared_ptr<const JobTolerances> tolerances;
};

class ToleranceCheck : public QObject {
    Q_OBJECT

public:
    ToleranceCheck(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                   QObject* parent = nullptr);

    // Dips first what of the document's result is out of date.
    void start(const Document& document);
    void cancel(); // a dip that is wanted meanwhile does not wait for it

signals:
    void done(const dipwright::ToleranceResult& told);

private:
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    CancelToken last_;
};

} // namespace dipwright
