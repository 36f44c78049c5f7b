// How long work tells how far it is and learns that it is no longer wanted.
#pragma once

#include <QString>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>

namespace dipwright {

// Thrown by work that noticed it was cancelled. Not an error: nothing is shown to the user.
class Cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "cancelled"; }
};

// A switch shared by who cancels and who works. Copies share the same switch. Any thread.
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

// What a piece of work is given. `report` may be empty; it is called from the working thread with
// the share done of this piece (0 … 1) and what is being done, at most some hundred times a second.
struct Progress {
    std::function<void(double, const QString&)> report;
    CancelToken cancelToken;

    // Reports and throws Cancelled when cancelled.
    void operator()(double share, const QString& text) const {
        cancelToken.throwIfCancelled();
        if (report) {
            report(share, text);
        }
    }
    // Cancelled together with this piece, and reports nothing: for what goes on beside it.
    Progress silent() const { return {nullptr, cancelToken}; }
    // The part from `begin` to `end` of this piece as a piece of its own.
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
