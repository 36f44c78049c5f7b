// Tells how long a test waits for an event.
#pragma once

#include <QtGlobal>

namespace dipwright {

// Returns the longest wait in ms: half of a test case's time limit, which is longer with
// sanitizers. No test asserts a time.
inline int patience() {
    const int limit = qEnvironmentVariableIntValue("QTEST_FUNCTION_TIMEOUT");
    return limit > 0 ? limit / 2 : 120'000;
}

} // namespace dipwright
