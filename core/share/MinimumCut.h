// Two labels for many items, chosen so that a cost is as small as it can be.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

struct CutEdge {
    std::uint32_t from = 0, to = 0; // items
    double cost = 0;                // ≥ 0, where they have different labels
};

// The labels, 0 or 1 an item, with the least sum of `costs` (an item each: what label 0 and label 1
// cost, ≥ 0) and of the edges between different labels: a minimum cut (Greig, Porteous & Seheult
// 1989). Of equal sums always the same one.
std::vector<std::uint8_t> minimumCut(const std::vector<std::array<double, 2>>& costs,
                                     const std::vector<CutEdge>& edges);

} // namespace dipwright
