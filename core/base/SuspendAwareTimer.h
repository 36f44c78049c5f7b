// How long something has been waited for, by a program that may itself be stopped meanwhile.
#pragma once

#include <algorithm>
#include <chrono>

namespace dipwright {

// Looked at again and again. Of what passes between two looks longestGap counts at most: while the
// program is suspended (Ctrl-Z, a debugger, a machine asleep) what it waits for is most often
// stopped, too, and has not had the time that the clock shows. One thread at a time.
class SuspendAwareTimer {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr Clock::duration longestGap = std::chrono::seconds(1);

    explicit SuspendAwareTimer(Clock::time_point now = Clock::now()) : lastLook_(now) {}

    // The time waited until now, counted.
    Clock::duration look(Clock::time_point now = Clock::now()) {
        waited_ += std::clamp(now - lastLook_, Clock::duration::zero(), longestGap);
        lastLook_ = now;
        return waited_;
    }

private:
    Clock::time_point lastLook_;
    Clock::duration waited_{};
};

} // namespace dipwright
