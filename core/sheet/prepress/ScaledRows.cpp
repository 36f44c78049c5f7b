#include "sheet/prepress/ScaledRows.h"

namespace dipwright {

ScaledSide::ScaledSide(int from, int to) {
    for (int i = 0; i < to; ++i) {
        const double at = (i + 0.5) * from / to - 0.5;
        const double left = std::floor(at);
        const auto t = float(at - left);
        Pixel pixel{{},
                    {((-0.5f * t + 1) * t - 0.5f) * t, (1.5f * t - 2.5f) * t * t + 1,
                     ((-1.5f * t + 2) * t + 0.5f) * t, (0.5f * t - 0.5f) * t * t}};
        for (int tap = 0; tap < 4; ++tap) {
            pixel.from[std::size_t(tap)] = std::clamp(int(left) - 1 + tap, 0, from - 1);
        }
        pixels_.push_back(pixel);
    }
}

} // namespace dipwright
