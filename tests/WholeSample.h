// How much of what is slow a test does: in an ordinary run a small sample, always the same one; in
// a whole run, DIPWRIGHT_TEST_ALL=1, as `scripts/test --all` sets it, all of it. Both assert the
// same (docs/contributing.md, "Test").
#pragma once

#include <cstdlib>
#include <string_view>

namespace dipwright::test {

inline bool isWholeRun() {
    const char* const all = std::getenv("DIPWRIGHT_TEST_ALL");
    return all && std::string_view(all) == "1";
}

// How many photographs, draws, damaged files or kill points.
inline int sampleOf(int small, int whole) {
    return isWholeRun() ? whole : small;
}

} // namespace dipwright::test
