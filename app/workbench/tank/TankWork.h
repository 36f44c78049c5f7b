// The work at the tank: which step of which job is due, and how long each step took. No widgets.
#pragma once

#include "traveller/TankTasks.h"

#include <QJsonObject>
#include <functional>
#include <optional>
#include <vector>

namespace dipwright {

class TankWork {
public:
    // Returns seconds of a clock that never jumps.
    using Clock = std::function<double()>;

    // `jobs` are done one after the other; each has at least one task. `now` is the local time as
    // ISO date and time, here and below.
    TankWork(std::vector<TankJob> jobs, Clock clock, const QString& now);

    const TankJob& job() const { return jobs_[job_]; }
    std::size_t jobNumber() const { return job_; } // from 0
    std::size_t jobCount() const { return jobs_.size(); }
    int run() const { return run_; } // of this job, from 1; a run makes one rack of parts
    // Null after the last step of the last job.
    const TankTask* task() const;
    const TankTask* nextTask() const;                // of the same job; null after its last step
    std::size_t taskNumber() const { return task_; } // from 0

    bool isPaused() const { return isPaused_; }
    Seconds spent() const; // on the current step, without pauses
    // Time until the step should end; negative: it takes longer than planned. None: no time is
    // given.
    std::optional<Seconds> left() const;

    // Ends the current step. If it was the job's last, the next job begins. Returns the times of
    // the job that has ended; otherwise empty.
    std::vector<TankTime> next(const QString& now);
    // Returns to the previous step of the same job and forgets its time. Its clock starts anew.
    void back(const QString& now);
    void setPaused(bool paused);
    // Starts the job that was done last once more, as the next run.
    void again(const QString& now);

    // The progress of the current job, to be restored by a later start. `wall` is the present time
    // of the wall clock, in seconds.
    QJsonObject progress(double wall) const;
    // Continues where the saved progress ended. If the step was not paused, its clock has run on
    // meanwhile. Ignores progress that does not fit the current job.
    void restore(const QJsonObject& progress, double wall);

private:
    void begin(std::size_t task, const QString& now);

    std::vector<TankJob> jobs_;
    Clock clock_;
    std::size_t job_ = 0, task_ = 0;
    int run_ = 1;
    bool isPaused_ = false, isDone_ = false;
    double began_ = 0; // time of the clock, moved by pauses; while paused, the spent seconds
    QString beganAt_;  // ISO date and time
    std::vector<TankTime> times_; // of this run
};

} // namespace dipwright
