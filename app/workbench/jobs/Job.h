// Long work in the background. A job uses no widgets, so it can be tested without a window.
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

    // Shown in the status bar: "Simulating the dip".
    virtual QString title() const = 0;
    // Worker thread. Throws Cancelled when cancelled, Error when the work fails.
    virtual void process(const Progress& progress) = 0;
    // UI thread, after process() has ended in any way. `failure` is null if the job succeeded or
    // was cancelled.
    virtual void finalize(bool cancelled, std::exception_ptr failure) = 0;
};

// A job from functions: `work` makes a value on the worker thread, `done` takes it on the UI
// thread, `failed` takes an exception.
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
