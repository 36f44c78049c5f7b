// How much ink to print so that the right colour shows on the stretched film (docs/film-model.md,
// "Ink").
#pragma once

#include "settings/InkSettings.h"
#include "texture/LinearLight.h"
#include "texture/Thinning.h"

namespace dipwright {

// Ink over a white body: density D = −log10 of a channel's linear light.
class InkCompensation {
public:
    explicit InkCompensation(const InkSettings& settings);

    struct Ink {
        LinearColour colour;     // to print
        bool fallsShort = false; // the body will be visibly paler than asked for
    };
    // The colour of a share of another's density, 0 … 1. Colour past the density limit fades as if
    // it were at the limit, or it could not fade at all.
    LinearColour faded(const LinearColour& colour, float share) const;
    // What to print so that `wanted` shows where the film's area has grown by `areaStretch`.
    Ink print(const LinearColour& wanted, float areaStretch) const;
    // What `printed` looks like on film that has grown by `areaStretch`.
    LinearColour shown(const LinearColour& printed, float areaStretch) const;

    // The tint of white, 0 … 1, to print so that `wanted` shows, as far as full tint goes.
    float printWhite(float wanted, float areaStretch) const;
    // What `printed` shows, 0 … 1.
    float shownWhite(float printed, float areaStretch) const;

private:
    bool compensate_;
    float darkest_; // the linear light of the density limit
    std::array<Thinning, lightInks> thinning_;
    Thinning white_;
};

} // namespace dipwright
