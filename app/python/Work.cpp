#include "python/Work.h"

#include "python/Values.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace dipwright::python {
namespace {

constexpr std::chrono::milliseconds signalInterval{50};

struct Step {
    double share = 0;
    QString text;
};

// What the working thread tells the calling thread.
class Bulletin {
public:
    void report(double share, const QString& text) {
        const std::scoped_lock lock(mutex_);
        newest_ = {share, text};
        changed_.notify_one();
    }
    void finish(std::exception_ptr failure) {
        const std::scoped_lock lock(mutex_);
        failure_ = std::move(failure);
        isFinished_ = true;
        changed_.notify_one();
    }
    // Waits for news, but not long. Returns false once the work has finished.
    bool wait(std::optional<Step>& step) {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, signalInterval, [this] { return newest_ || isFinished_; });
        step = std::exchange(newest_, {});
        return !isFinished_;
    }
    std::exception_ptr failure() const { return failure_; } // once the work has finished

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Step> newest_;
    std::exception_ptr failure_;
    bool isFinished_ = false;
};

// Calls `report`. Returns false if the work is to be cancelled.
bool wantsMore(const py::object& report, const std::optional<Step>& step) {
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
    return !step || report.is_none() || boolOf(report(step->share, step->text)) != false;
}

} // namespace

void runWork(const py::object& report, const std::function<void(const Progress&)>& work) {
    Bulletin bulletin;
    Progress progress;
    progress.report = [&](double share, const QString& text) { bulletin.report(share, text); };
    CancelToken cancelToken = progress.cancelToken;
    std::thread worker([&] {
        std::exception_ptr failure;
        try {
            work(progress);
        } catch (...) {
            failure = std::current_exception();
        }
        bulletin.finish(failure);
    });
    std::exception_ptr interruption;
    for (bool works = true; works;) {
        std::optional<Step> step;
        {
            const py::gil_scoped_release released;
            works = bulletin.wait(step);
        }
        try {
            if (!cancelToken.isCancelled() && !wantsMore(report, step)) {
                cancelToken.cancel();
            }
        } catch (py::error_already_set&) {
            interruption = std::current_exception();
            cancelToken.cancel();
        }
    }
    worker.join(); // it has finished
    if (interruption) {
        std::rethrow_exception(interruption);
    }
    if (bulletin.failure()) {
        std::rethrow_exception(bulletin.failure());
    }
}

} // namespace dipwright::python
