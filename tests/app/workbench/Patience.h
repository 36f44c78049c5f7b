// How long a test waits for what is to happen in it.
#pragma once

#include <QtGlobal>

namespace dipwright {

// In milliseconds: half of what a test case may take in all, which is more with a sanitizer.
// Nothing is asserted about time.
inline int patience() {
    const int limit = qEnvironmentVariableIntValue("QTEST_FUNCTION_TIMEOUT");
    return limit > 0 ? limit / 2 : 120'000;
}

} // namespace dipwright
