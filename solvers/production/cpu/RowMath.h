// Sums over rows of floats in a fixed order: sixteen running sums, the same on every instruction
// set.
#pragma once

#include <cstddef>

namespace dipwright::cpu {

double rowDot(const float* a, const float* b, std::size_t count);

// Σ weight·a².
double rowWeightedSquares(const float* weight, const float* a, std::size_t count);

} // namespace dipwright::cpu
