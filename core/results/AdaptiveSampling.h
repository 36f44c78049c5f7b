// Decides which pixels of a picture need more than one sample: only pixels that differ from their
// neighbours.
#pragma once

#include <QSize>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dipwright {

// Red, green and blue, encoded as in a picture.
using PixelBytes = std::array<std::uint8_t, 3>;

// Tells whether a pixel looks the same as its neighbours. `pixels` holds the colours row by row,
// each from one sample in the pixel's centre.
bool isEven(const std::vector<PixelBytes>& pixels, QSize size, int x, int y);

} // namespace dipwright
