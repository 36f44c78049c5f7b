#include "workbench/jobs/JobRunner.h"

#include "base/PostToThread.h"

#include <cstdlib>

namespace dipwright {

JobRunner::JobRunner(QObject* parent) : QObject(parent), worker_([this] { work(); }) {}

JobRunner::~JobRunner() {
    cancelAll();
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_all();
    {
        std::unique_lock lock(mutex_);
        if (!gone_.wait_for(lock, longestEnd, [this] { return ended_; })) {
            std::_Exit(EXIT_FAILURE);
        }
    }
    worker_.join();
}

CancelToken JobRunner::start(std::unique_ptr<Job> job) {
    ++unfinished_;
    const CancelToken cancelToken;
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back({std::move(job), cancelToken});
    }
    wake_.notify_all();
    if (unfinished_ == 1) {
        emit busy();
    }
    return cancelToken;
}

void JobRunner::cancelAll() {
    const std::lock_guard lock(mutex_);
    current_.cancel();
    for (Entry& entry : waiting_) {
        entry.cancelToken.cancel();
    }
}

void JobRunner::work() {
    while (true) {
        Entry entry;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (ending_) {
                ended_ = true;
                gone_.notify_all();
                return;
            }
            entry = waiting_.front();
            waiting_.pop_front();
            current_ = entry.cancelToken;
        }
        run(entry);
    }
}

void JobRunner::run(const Entry& entry) {
    postToThread(*this, [this, title = entry.job->title()] { emit started(title); });
    bool cancelled = false;
    std::exception_ptr failure;
    try {
        const Progress progress{[this](double share, const QString& text) { report(share, text); },
                                entry.cancelToken};
        entry.cancelToken.throwIfCancelled();
        entry.job->process(progress);
    } catch (const Cancelled&) {
        cancelled = true;
    } catch (...) {
        failure = std::current_exception();
    }
    postToThread(*this, [this, job = entry.job, token = entry.cancelToken, cancelled, failure] {
        --unfinished_;
        // A job that the user has cancelled leaves nothing, even if it ended meanwhile.
        job->finalize(cancelled || token.isCancelled(), failure);
        if (unfinished_ == 0) {
            emit idle();
        }
    });
}

// The UI thread has at most one pending message, with the latest state, however often the work
// reports.
void JobRunner::report(double share, const QString& text) {
    const std::lock_guard lock(mutex_);
    share_ = share;
    text_ = text;
    if (!reportPending_) {
        reportPending_ = true;
        postToThread(*this, [this] { deliverReport(); });
    }
}

void JobRunner::deliverReport() {
    double share = 0;
    QString text;
    {
        const std::lock_guard lock(mutex_);
        reportPending_ = false;
        share = share_;
        text = text_;
    }
    emit progressed(share, text);
}

} // namespace dipwright
