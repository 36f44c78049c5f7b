// Simulates the last dip of a result again with a greater depth, so that its film can be shown.
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

    // Simulates the last dip of `result`. Does nothing if the last request had the same result and
    // was not cancelled.
    void start(const std::shared_ptr<const JobResult>& result);
    void cancel(); // cancels the simulation, so that another dip need not wait for it

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
