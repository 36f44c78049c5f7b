#include "base/ProcessorTime.h"

#include <QtGlobal>

#ifdef Q_OS_WIN
#include <qt_windows.h>
#else
#include <ctime>
#endif

namespace dipwright {

std::chrono::nanoseconds threadProcessorTime() {
#ifdef Q_OS_WIN
    constexpr qint64 unit = 100; // ns
    FILETIME begin{}, end{}, kernel{}, user{};
    GetThreadTimes(GetCurrentThread(), &begin, &end, &kernel, &user);
    const auto ticks = [](const FILETIME& time) {
        return qint64(time.dwHighDateTime) << 32 | qint64(time.dwLowDateTime);
    };
    return std::chrono::nanoseconds(unit * (ticks(kernel) + ticks(user)));
#else
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
#endif
}

} // namespace dipwright
