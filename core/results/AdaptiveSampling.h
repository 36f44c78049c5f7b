// Where a picture that is traced needs more than one ray a pixel. Most pixels show light that
// hardly changes; only where neighbours differ one is worth several.
#pragma once

#include <QSize>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dipwright {

// Red, green and blue as a picture has them.
using PixelBytes = std::array<std::uint8_t, 3>;

// Whether a pixel is like its neighbours, as far as anyone sees. `pixels`: row by row, what one ray
// through each one's middle tells.
bool isEven(const std::vector<PixelBytes>& pixels, QSize size, int x, int y);

} // namespace dipwright
