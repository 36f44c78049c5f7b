// Starts a job from two functions and reports its failure to the user.
#pragma once

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

#include <type_traits>

namespace dipwright {

// `work` makes a value on the worker thread and reports to a Progress. `done` takes it on the UI
// thread. `title` names the job; `failureTitle` is the title of an error message. `jobs` and
// `messages` must outlive the job.
template <typename Work, typename Done>
CancelToken startJob(JobRunner& jobs, Messages& messages, const QString& title,
                     const QString& failureTitle, Work work, Done done) {
    using Value = std::invoke_result_t<Work, const Progress&>;
    return jobs.start(std::make_unique<ValueJob<Value>>(
        title, std::move(work), std::move(done),
        [&messages, failureTitle](const std::exception_ptr& failure) {
            messages.fail(failureTitle, failure);
        }));
}

} // namespace dipwright
