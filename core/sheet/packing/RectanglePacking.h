// Rectangles packed into others of one size, upright or turned by a quarter, without overlap.
#pragma once

#include <QRect>
#include <vector>

namespace dipwright {

enum class Turning { Never, Allowed, Always };

struct PackItem {
    QSize size;
    Turning turning = Turning::Never;
};

// `box`: where it lies, of the turned size where `turned`.
struct PackPlace {
    std::size_t item = 0; // its number
    QRect box;
    bool turned = false;
};

// Whether a bin takes an item at all.
bool fits(const PackItem& item, QSize bin);

// Items into as few bins as it finds, and of the last one the upper part: a bin's places each. Each
// item fits. Those of one size come to lie in rows. By maximal rectangles (Jylänki 2010, "A
// Thousand Ways to Pack the Bin"), the uppermost place first, in several orders of which the best
// counts. The same for the same items. Some thousand items take a second.
std::vector<std::vector<PackPlace>> packed(const std::vector<PackItem>& items, QSize bin);

} // namespace dipwright
