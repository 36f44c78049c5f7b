// Measures waiting time in a program that may be suspended while it waits.
#pragma once

#include <algorithm>
#include <chrono>

namespace dipwright {

// Call look() repeatedly. The time between two calls counts up to longestGap. The reason: while
// this program is suspended (Ctrl-Z, debugger, sleeping machine), the process that it waits for
// usually stops too. Not thread-safe.
class SuspendAwareTimer {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr Clock::duration longestGap = std::chrono::seconds(1);

    explicit SuspendAwareTimer(Clock::time_point now = Clock::now()) : lastCall_(now) {}

    // Returns the time that has counted until now.
    Clock::duration look(Clock::time_point now = Clock::now()) {
        waited_ += std::clamp(now - lastCall_, Clock::duration::zero(), longestGap);
        lastCall_ = now;
        return waited_;
    }

private:
    Clock::time_point lastCall_;
    Clock::duration waited_{};
};

} // namespace dipwright
