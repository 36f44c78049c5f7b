#include "texture/Ink.h"

#include "texture/ToneCurve.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr float log2Of10 = 3.3219281f;
constexpr float leastStretch = 0.05f; // used for film folded flat; keeps powers finite
constexpr float leastLight = 1e-12f;  // keeps the logarithms finite

// Returns the logarithm of a light's density; −∞ for white.
float logDensity(float light) {
    return std::log(-std::log2(std::clamp(light, leastLight, 1.0f)) / log2Of10);
}

} // namespace

InkCompensation::InkCompensation(const InkSettings& settings)
    : compensate_(settings.compensate), limit_(float(settings.limit)),
      densest_(float(settings.densest)), passes_(float(settings.printedPasses())),
      darkest_(std::exp2(-log2Of10 * limit_)),
      darkestPrinted_(std::exp2(-log2Of10 * limit_ * passes_)),
      thinning_{Thinning(settings.law, FilmInk::Cyan), Thinning(settings.law, FilmInk::Magenta),
                Thinning(settings.law, FilmInk::Yellow)},
      white_(settings.law, FilmInk::White) {}

InkCompensation::Ink InkCompensation::print(const LinearColour& wanted, float areaStretch) const {
    Ink ink{wanted, false};
    if (!compensate_) {
        return ink;
    }
    const float stretch = std::max(areaStretch, leastStretch);
    for (int channel = 0; channel < lightInks; ++channel) {
        const float light = wanted[channel];
        const Thinning& thinning = thinning_[std::size_t(channel)];
        const float factor = thinning.byShown(logDensity(light), stretch);
        const float compensated = std::exp2(factor * std::log2(light));
        ink.colour[channel] = std::max(compensated, std::min(light, darkestPrinted_));
        if (compensated < darkestPrinted_) {
            const float reached = std::max(ink.colour[channel], darkestPrinted_);
            const float missing =
                std::log2(reached) / thinning.byPrinted(logDensity(reached), stretch) -
                std::log2(std::max(light, darkest_));
            ink.fallsShort = ink.fallsShort || missing > visibleDensity * log2Of10;
        }
    }
    ink.colour = ofOnePass(ink.colour);
    return ink;
}

LinearColour InkCompensation::ofOnePass(const LinearColour& all) const {
    return passes_ == 1 ? all : LinearColour(all.max(0).pow(1 / passes_));
}

LinearColour InkCompensation::toned(const LinearColour& colour) const {
    if (densest_ >= limit_) {
        return colour;
    }
    const LinearColour printable = colour.max(darkest_);
    const float density = -std::log2(printable.minCoeff()) / log2Of10;
    const float lightened = tonedDensity(density, densest_, limit_);
    return lightened < density ? LinearColour(printable.pow(lightened / density)) : colour;
}

LinearColour InkCompensation::faded(const LinearColour& colour, float share) const {
    return share < 1 ? LinearColour(colour.max(darkest_).pow(share)) : colour;
}

LinearColour InkCompensation::shown(const LinearColour& printed, float areaStretch) const {
    const float stretch = std::max(areaStretch, leastStretch);
    LinearColour colour;
    for (int channel = 0; channel < lightInks; ++channel) {
        const float onePass = std::max(printed[channel], 0.0f);
        const float light = passes_ == 1 ? onePass : std::pow(onePass, passes_);
        const float factor = thinning_[std::size_t(channel)].byPrinted(logDensity(light), stretch);
        colour[channel] = std::pow(light, 1 / factor);
    }
    return colour;
}

float InkCompensation::printWhite(float wanted, float areaStretch) const {
    const float stretch = std::max(areaStretch, leastStretch);
    const float all = compensate_ ? wanted * white_.byShown(std::log(wanted), stretch) : wanted;
    return std::min(1.0f, all / passes_);
}

float InkCompensation::shownWhite(float printed, float areaStretch) const {
    const float stretch = std::max(areaStretch, leastStretch);
    const float all = printed * passes_;
    return std::min(1.0f, all / white_.byPrinted(std::log(all), stretch));
}

} // namespace dipwright
