#include "texture/Ink.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Densities closer than this are alike to the eye.
constexpr float visibleDensity = 0.05f;
constexpr float log2Of10 = 3.3219281f;
constexpr float leastStretch = 0.05f; // film folded flat; keeps the powers finite
constexpr float leastLight = 1e-12f;  // keeps the logarithms finite

// Of the density of light, −∞ for white.
float logDensity(float light) {
    return std::log(-std::log2(std::clamp(light, leastLight, 1.0f)) / log2Of10);
}

} // namespace

InkCompensation::Thinning::Thinning(const InkLaw& law, ProcessInk ink)
    : exponent_(float(law.exponents[std::size_t(ink)])) {
    for (const InkTone& tone : law.tones) {
        if (tone.ink == ink) {
            tones_.push_back({float(std::log(tone.density)), float(tone.exponent), float(tone.bend),
                              float(std::log(tone.mostStretch))});
        }
    }
}

float InkCompensation::Thinning::ofLayer(float areaStretch) const {
    return exponent_ == 1 ? areaStretch : std::pow(areaStretch, exponent_);
}

// The logarithm of the density that a tone shows; `grown`: of J.
float InkCompensation::Thinning::shownAt(const Tone& tone, float grown) const {
    const float bent = tone.bend * std::clamp(grown, 0.0f, tone.mostGrown);
    return tone.density - (tone.exponent + bent) * grown;
}

float InkCompensation::Thinning::byPrinted(float light, float areaStretch) const {
    if (tones_.empty()) {
        return ofLayer(areaStretch);
    }
    const float grown = std::log(areaStretch), printed = logDensity(light);
    const auto above =
        std::lower_bound(tones_.begin(), tones_.end(), printed,
                         [](const Tone& tone, float value) { return tone.density < value; });
    const auto thinner = [&](const Tone& tone) { return tone.density - shownAt(tone, grown); };
    if (above == tones_.begin() || above == tones_.end()) {
        return std::exp(thinner(above == tones_.end() ? tones_.back() : tones_.front()));
    }
    const auto below = above - 1;
    const float share = (printed - below->density) / (above->density - below->density);
    return std::exp(thinner(*below) + share * (thinner(*above) - thinner(*below)));
}

float InkCompensation::Thinning::byShown(float light, float areaStretch) const {
    if (tones_.empty()) {
        return ofLayer(areaStretch);
    }
    const float grown = std::log(areaStretch), shown = logDensity(light);
    const auto above =
        std::lower_bound(tones_.begin(), tones_.end(), shown, [&](const Tone& tone, float value) {
            return shownAt(tone, grown) < value;
        });
    if (above == tones_.begin() || above == tones_.end()) {
        const Tone& tone = above == tones_.end() ? tones_.back() : tones_.front();
        return std::exp(tone.density - shownAt(tone, grown));
    }
    const auto below = above - 1;
    const float low = shownAt(*below, grown), high = shownAt(*above, grown);
    const float share = (shown - low) / (high - low);
    return std::exp(below->density + share * (above->density - below->density) - shown);
}

InkCompensation::InkCompensation(const InkSettings& settings)
    : compensate_(settings.compensate), darkest_(std::exp2(-log2Of10 * float(settings.limit))),
      thinning_{Thinning(settings.law, ProcessInk::Cyan),
                Thinning(settings.law, ProcessInk::Magenta),
                Thinning(settings.law, ProcessInk::Yellow)} {}

InkCompensation::Ink InkCompensation::print(const LinearColour& wanted, float areaStretch) const {
    Ink ink{wanted, false};
    if (!compensate_) {
        return ink;
    }
    const float stretch = std::max(areaStretch, leastStretch);
    for (int channel = 0; channel < 3; ++channel) {
        const float light = wanted[channel];
        const Thinning& thinning = thinning_[std::size_t(channel)];
        const float factor = thinning.byShown(light, stretch);
        const float compensated = std::exp2(factor * std::log2(light));
        ink.colour[channel] = std::max(compensated, std::min(light, darkest_));
        if (compensated < darkest_) {
            const float reached = std::max(ink.colour[channel], darkest_);
            const float missing = std::log2(reached) / thinning.byPrinted(reached, stretch) -
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
    const float stretch = std::max(areaStretch, leastStretch);
    LinearColour colour;
    for (int channel = 0; channel < 3; ++channel) {
        const float light = std::max(printed[channel], 0.0f);
        const float factor = thinning_[std::size_t(channel)].byPrinted(light, stretch);
        colour[channel] = std::pow(light, 1 / factor);
    }
    return colour;
}

} // namespace dipwright
