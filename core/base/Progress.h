// Progress reports and cancellation for long tasks.
#pragma once

#include <QString>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>

namespace dipwright {

// Thrown by work that was cancelled. It is not an error: nothing is shown to the user.
class Cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "cancelled"; }
};

// A flag that one side sets to cancel and the other side checks. Copies share the flag.
// Thread-safe.
class CancelToken {
public:
    void cancel() { *flag_ = true; }
    bool isCancelled() const { return *flag_; }
    void throwIfCancelled() const {
        if (isCancelled()) {
            throw Cancelled();
        }
    }

private:
    std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

// A piece of work reports its progress through this object, and checks it for cancellation.
// `report` may be empty. Its arguments are the progress (0 … 1) and a text that says what is being
// done. The working thread calls it at most a few hundred times a second.
struct Progress {
    std::function<void(double, const QString&)> report;
    CancelToken cancelToken;

    // Reports progress. Throws Cancelled if the work was cancelled.
    void operator()(double share, const QString& text) const {
        cancelToken.throwIfCancelled();
        if (report) {
            report(share, text);
        }
    }
    // Returns a Progress that shares this one's cancellation but reports nothing. Use it for work
    // that runs in parallel.
    Progress silent() const { return {nullptr, cancelToken}; }
    // Returns a Progress for a part of the work: its 0 … 1 is reported as `begin` … `end`.
    Progress part(double begin, double end) const {
        Progress inner{nullptr, cancelToken};
        if (report) {
            inner.report = [outer = report, begin, end](double share, const QString& text) {
                outer(begin + share * (end - begin), text);
            };
        }
        return inner;
    }
};

} // namespace dipwright
