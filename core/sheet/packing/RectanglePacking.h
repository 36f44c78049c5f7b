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

// The place of an item. If `turned` is true, `box` has the width and height of the turned item.
struct PackPlace {
    std::size_t item = 0; // index of the item
    QRect box;
    bool turned = false;
};

// Tells whether an item fits an empty bin.
bool fits(const PackItem& item, QSize bin);

// Packs the items into as few bins as possible and fills only the upper part of the last bin.
// Returns the places in each bin. Each item must fit a bin. Items of one size lie in rows. Uses
// maximal rectangles (Jylänki 2010, "A Thousand Ways to Pack the Bin"), takes the uppermost place
// first, tries several orders of the items and returns the best result. Deterministic. Some
// thousand items take a second.
std::vector<std::vector<PackPlace>> packed(const std::vector<PackItem>& items, QSize bin);

} // namespace dipwright
