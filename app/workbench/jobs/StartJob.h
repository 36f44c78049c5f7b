// A job from two functions, of whose failure the user is told.
#pragma once

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

#include <type_traits>

namespace dipwright {

// `work` (on the worker thread, given a Progress) makes the value that `done` (on the UI thread)
// takes. `title` is what runs; `failureTitle` stands over what went wrong. Jobs and messages must
// live until it has ended.
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
