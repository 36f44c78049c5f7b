// Makes rows of random numbers for tests of row kernels.
#pragma once

#include <algorithm>
#include <bit>
#include <random>
#include <vector>

namespace dipwright::test {

using Row = std::vector<float>;

inline Row randomRow(std::size_t count, unsigned seed, float from = -1, float to = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(from, to);
    Row row(count);
    std::generate(row.begin(), row.end(), [&] { return number(random); });
    return row;
}

inline bool haveSameBits(const Row& a, const Row& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float left, float right) {
        return std::bit_cast<unsigned>(left) == std::bit_cast<unsigned>(right);
    });
}

} // namespace dipwright::test
