// Measures how long the window blocks: the times between two turns of its event loop.
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

namespace dipwright::bench {

inline constexpr double longGap = 50; // ms

// Returns the processor time of this thread in ms, without other programs' work; 0 if unknown.
inline double threadMilliseconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
#else
    return 0;
#endif
}

class Heartbeat {
public:
    Heartbeat() {
        timer_.setTimerType(Qt::PreciseTimer);
        timer_.setInterval(1);
        QObject::connect(&timer_, &QTimer::timeout, [this] {
            gaps_.push_back(double(clock_.nsecsElapsed()) / 1e6);
            const double now = threadMilliseconds();
            mostWork_ = std::max(mostWork_, now - workBefore_);
            workBefore_ = now;
            clock_.start();
        });
    }
    void start() {
        gaps_.clear();
        mostWork_ = 0;
        workBefore_ = threadMilliseconds();
        clock_.start();
        timer_.start();
    }
    void print(const char* what) {
        timer_.stop();
        std::sort(gaps_.begin(), gaps_.end());
        const auto longOnes =
            std::count_if(gaps_.begin(), gaps_.end(), [](double gap) { return gap > longGap; });
        std::printf("%-12s beats %6zu  99 %% below %6.1f ms  longest %6.1f ms  over %.0f ms: %td  "
                    "most work %6.1f ms\n",
                    what, gaps_.size(), gaps_[gaps_.size() * 99 / 100], gaps_.back(), longGap,
                    longOnes, mostWork_);
        std::fflush(stdout);
    }

private:
    QTimer timer_;
    QElapsedTimer clock_;
    std::vector<double> gaps_;
    double workBefore_ = 0, mostWork_ = 0; // processor time of this thread in one turn, ms
};

} // namespace dipwright::bench
