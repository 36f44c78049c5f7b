// Long work beside the user interface. A job knows no widgets: it is tested without a window.
#pragma once

#include "base/Progress.h"

#include <exception>
#include <functional>
#include <optional>
#include <utility>

namespace dipwright {

class Job {
public:
    virtual ~Job() = default;

    // What the status bar calls it: "Simulating the dip".
    virtual QString title() const = 0;
    // On the worker thread. Throws Cancelled when cancelled, Error when it cannot be done.
    virtual void process(const Progress& progress) = 0;
    // On the UI thread, after process() has ended in whichever way; `failure` is null when it was
    // done or cancelled.
    virtual void finalize(bool cancelled, std::exception_ptr failure) = 0;
};

// A job from two functions: `work` makes a value on the worker thread, `done` takes it on the UI
// thread. `failed` gets what went wrong.
template <typename Value>
class ValueJob : public Job {
public:
    using Work = std::function<Value(const Progress&)>;
    using Done = std::function<void(Value)>;
    using Failed = std::function<void(std::exception_ptr)>;

    ValueJob(const QString& title, Work work, Done done, Failed failed)
        : title_(title), work_(std::move(work)), done_(std::move(done)),
          failed_(std::move(failed)) {}

    QString title() const override { return title_; }
    void process(const Progress& progress) override { value_.emplace(work_(progress)); }
    void finalize(bool cancelled, std::exception_ptr failure) override {
        if (failure) {
            failed_(failure);
        } else if (!cancelled) {
            done_(std::move(*value_));
        }
    }

private:
    QString title_;
    Work work_;
    Done done_;
    Failed failed_;
    std::optional<Value> value_;
};

} // namespace dipwright
