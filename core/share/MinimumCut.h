// Assigns one of two labels to each item so that the total cost is minimal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

struct CutEdge {
    std::uint32_t from = 0, to = 0; // items
    double cost = 0;                // ≥ 0; applies if the two labels differ
};

// Returns the label of each item, 0 or 1, that minimises the sum of all costs. `costs` holds per
// item the cost of label 0 and of label 1, ≥ 0. The cost of an edge is added if its items have
// different labels. This is a minimum cut (Greig, Porteous & Seheult 1989). Deterministic, even if
// several solutions have the same sum.
std::vector<std::uint8_t> minimumCut(const std::vector<std::array<double, 2>>& costs,
                                     const std::vector<CutEdge>& edges);

} // namespace dipwright
