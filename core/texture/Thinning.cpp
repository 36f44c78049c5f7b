#include "texture/Thinning.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

Thinning::Thinning(const InkLaw& law, FilmInk ink)
    : exponent_(float(law.exponents[std::size_t(ink)])) {
    for (const InkTone& tone : law.tones) {
        if (tone.ink == ink) {
            tones_.push_back({float(std::log(tone.density)), float(tone.exponent), float(tone.bend),
                              float(std::log(tone.mostStretch))});
        }
    }
}

float Thinning::layerThinning(float areaStretch) const {
    return exponent_ == 1 ? areaStretch : std::pow(areaStretch, exponent_);
}

// Returns the logarithm of the density that a tone shows on stretched film. `grown` is the
// logarithm of the area stretch.
float Thinning::shownAt(const Tone& tone, float grown) const {
    const float bent = tone.bend * std::clamp(grown, 0.0f, tone.mostGrown);
    return tone.density - (tone.exponent + bent) * grown;
}

float Thinning::byPrinted(float printed, float areaStretch) const {
    if (tones_.empty()) {
        return layerThinning(areaStretch);
    }
    const float grown = std::log(areaStretch);
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

float Thinning::byShown(float shown, float areaStretch) const {
    if (tones_.empty()) {
        return layerThinning(areaStretch);
    }
    const float grown = std::log(areaStretch);
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

} // namespace dipwright
