// Computes how much ink to print so that the right colour shows on the stretched film
// (docs/film-model.md, "Ink").
#pragma once

#include "settings/InkSettings.h"
#include "texture/LinearLight.h"
#include "texture/Thinning.h"

namespace dipwright {

// A place is visibly too pale if more density than this is missing.
inline constexpr float visibleDensity = 0.05f;

// Models ink over a white body: density D = −log10 of a channel's linear light. A picture to print
// has the ink of one pass; all passes of the settings lie on one another.
class InkCompensation {
public:
    explicit InkCompensation(const InkSettings& settings);

    struct Ink {
        LinearColour colour;     // colour to print
        bool fallsShort = false; // whether the body becomes visibly paler than wanted
    };
    // Returns a colour of the texture as the body should show it: lightened by the tone curve,
    // which multiplies the densities of all channels by one factor and so keeps the hue.
    LinearColour toned(const LinearColour& colour) const;
    // Returns `colour` with its density multiplied by `share`, 0 … 1. A density above the ink limit
    // is first reduced to the limit, because it would otherwise show no fading.
    LinearColour faded(const LinearColour& colour, float share) const;
    // Returns the colour to print, so that film whose area has grown by `areaStretch` shows
    // `wanted`.
    Ink print(const LinearColour& wanted, float areaStretch) const;
    // Returns how `printed` looks on film whose area has grown by `areaStretch`.
    LinearColour shown(const LinearColour& printed, float areaStretch) const;

    // Returns the tint of white, 0 … 1, to print, so that such film shows the tint `wanted`.
    float printWhite(float wanted, float areaStretch) const;
    // Returns the tint, 0 … 1, that shows if the tint `printed` was printed.
    float shownWhite(float printed, float areaStretch) const;

private:
    LinearColour ofOnePass(const LinearColour& all) const;

    bool compensate_;
    float limit_, densest_; // densities
    float passes_;
    float darkest_;        // linear light at the ink limit
    float darkestPrinted_; // linear light at the ink limit in every pass
    std::array<Thinning, lightInks> thinning_;
    Thinning white_;
};

} // namespace dipwright
