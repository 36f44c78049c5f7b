// Packs rectangles into bins of one size, upright or turned by a quarter, without overlap.
#pragma once

#include <QRect>
#include <vector>

namespace dipwright {

enum class Turning { Never, Allowed, Always };

struct PackItem {
    QSize size;
    Turning turning = Turning::Never;
};

// `box` has the turned size if `turned`.
struct PackPlace {
    std::size_t item = 0; // index of the item
    QRect box;
    bool turned = false;
};

// Tells whether an item fits an empty bin.
bool fits(const PackItem& item, QSize bin);

// Packs the items into as few bins as it finds; of the last bin it fills only the upper part.
// Returns the places per bin. Each item must fit a bin. Items of one size lie in rows. Uses maximal
// rectangles (Jylänki 2010, "A Thousand Ways to Pack the Bin"): the uppermost place first, in
// several orders, of which the best is returned. Deterministic. Some thousand items take a second.
std::vector<std::vector<PackPlace>> packed(const std::vector<PackItem>& items, QSize bin);

} // namespace dipwright
