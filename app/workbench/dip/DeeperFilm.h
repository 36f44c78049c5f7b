// The second film of a document's result as it would lie on a body dipped deeper, dipped when it is
// asked for.
#pragma once

#include "pipeline/JobResult.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

class DeeperFilm : public QObject {
    Q_OBJECT

public:
    DeeperFilm(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
               QObject* parent = nullptr);

    // Of the last immersion; nothing where that was asked for last and not
    // cancelled.
    void start(const std::shared_ptr<const JobResult>& result);
    void cancel(); // a dip that is wanted meanwhile does not wait for it

signals:
    void done(const std::shared_ptr<const dipwright::JobResult>& result,
              const std::shared_ptr<const dipwright::LaidFilm>& film);

private:
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    CancelToken last_;
    std::weak_ptr<const JobResult> asked_;
};

} // namespace dipwright
