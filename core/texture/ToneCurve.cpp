#include "texture/ToneCurve.h"

#include <algorithm>

namespace dipwright {

float tonedDensity(float density, float densest, float limit) {
    const float knee = densest / 4;
    if (densest >= limit || density <= knee) {
        return density;
    }
    const float range = limit - knee, left = densest - knee;
    const float above = std::min(density, limit) - knee;
    return knee + above / (1 + (1 / left - 1 / range) * above);
}

} // namespace dipwright
