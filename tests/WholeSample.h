// Tells slow tests how many cases to run. An ordinary run takes a small, fixed sample. A whole run
// (DIPWRIGHT_TEST_ALL=1, set by `scripts/test --all`) takes all cases. Both assert the same
// (docs/contributing.md, "Test").
#pragma once

#include <cstdlib>
#include <string_view>

namespace dipwright::test {

inline bool isWholeRun() {
    const char* const all = std::getenv("DIPWRIGHT_TEST_ALL");
    return all && std::string_view(all) == "1";
}

// Returns the number of photos, draws, damaged files or kill points for this run.
inline int sampleOf(int small, int whole) {
    return isWholeRun() ? whole : small;
}

} // namespace dipwright::test
