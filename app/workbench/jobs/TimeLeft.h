// How long a job will still take, estimated from its progress reports.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

namespace dipwright {

class JobRunner;

// The progress of a job: its share, 0 … 1, at a time in seconds since its start.
struct JobProgress {
    double seconds = 0;
    double share = 0;
};

// Returns the seconds from the time `now` to the end of the job; none if not known yet. `reports`
// are in the order of time; each has a greater share than the one before. The speed is that of the
// second half of the elapsed time, because the first stages may have been skipped. Between two
// reports the time runs down, and stops when a report is late.
std::optional<double> secondsLeft(const std::vector<JobProgress>& reports, double now);

// Returns the seconds to show: `left` rounded up to a step that grows with it. Keeps `shown`, the
// number shown before, while the estimate has grown only a little, so that the number does not
// jump.
double steadySeconds(double left, std::optional<double> shown);

// "about 40 s left"
QString timeLeftText(double seconds);

// Follows the jobs of a runner.
class TimeLeft : public QObject {
    Q_OBJECT

public:
    explicit TimeLeft(const JobRunner& jobs, QObject* parent = nullptr);

signals:
    void told(const QString& text); // at most once a second; empty: not known

private:
    void begin();
    void add(double share);
    void tell();

    std::vector<JobProgress> reports_;
    std::optional<double> shown_;
    QElapsedTimer clock_; // runs since the job began
    QTimer tick_;
};

} // namespace dipwright
