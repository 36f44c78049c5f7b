// Measures waiting time in a program that may itself be suspended meanwhile.
#pragma once

#include <algorithm>
#include <chrono>

namespace dipwright {

// Call look() repeatedly. At most longestGap counts between two calls. The reason: while this
// program is suspended (Ctrl-Z, debugger, sleeping machine), the process that it waits for usually
// stops too. Not thread-safe.
class SuspendAwareTimer {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr Clock::duration longestGap = std::chrono::seconds(1);

    explicit SuspendAwareTimer(Clock::time_point now = Clock::now()) : lastLook_(now) {}

    // Returns the time that has counted until now.
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
