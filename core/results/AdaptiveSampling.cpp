#include "results/AdaptiveSampling.h"

#include <algorithm>
#include <cstdlib>

namespace dipwright {
namespace {

constexpr int invisibleStep = 2; // invisible difference between neighbours, of 255

bool isAlike(const PixelBytes& one, const PixelBytes& other) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (std::abs(int(one[channel]) - int(other[channel])) > invisibleStep) {
            return false;
        }
    }
    return true;
}

} // namespace

bool isEven(const std::vector<PixelBytes>& pixels, QSize size, int x, int y) {
    const auto at = [&](int i, int j) -> const PixelBytes& {
        return pixels[std::size_t(j) * std::size_t(size.width()) + std::size_t(i)];
    };
    const PixelBytes& own = at(x, y);
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.height() - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size.width() - 1); ++i) {
            if (!isAlike(own, at(i, j))) {
                return false;
            }
        }
    }
    return true;
}

} // namespace dipwright
