#include "texture/Ink.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Densities closer than this are alike to the eye.
constexpr float visibleDensity = 0.05f;
constexpr float log2Of10 = 3.3219281f;
constexpr float leastStretch = 0.05f; // film folded flat; keeps the powers finite

} // namespace

InkCompensation::InkCompensation(const InkSettings& settings)
    : compensate_(settings.compensate), darkest_(std::exp2(-log2Of10 * float(settings.limit))) {}

InkCompensation::Ink InkCompensation::print(const LinearColour& wanted, float areaStretch) const {
    Ink ink{wanted, false};
    if (!compensate_) {
        return ink;
    }
    const float stretch = std::max(areaStretch, leastStretch);
    for (int channel = 0; channel < 3; ++channel) {
        const float light = wanted[channel];
        const float compensated = std::exp2(stretch * std::log2(light));
        ink.colour[channel] = std::max(compensated, std::min(light, darkest_));
        if (compensated < darkest_) {
            const float missing = std::log2(std::max(ink.colour[channel], darkest_)) / stretch -
                                  std::log2(std::max(light, darkest_));
            ink.fallsShort = ink.fallsShort || missing > visibleDensity * log2Of10;
        }
    }
    return ink;
}

LinearColour InkCompensation::faded(const LinearColour& colour, float share) const {
    return share < 1 ? LinearColour(colour.max(darkest_).pow(share)) : colour;
}

LinearColour InkCompensation::shown(const LinearColour& printed, float areaStretch) const {
    return printed.max(0.0f).pow(1 / std::max(areaStretch, leastStretch));
}

} // namespace dipwright
