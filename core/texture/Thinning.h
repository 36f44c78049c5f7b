// Evaluates one ink's law (texture/InkLaw.h) fast enough for every pixel.
#pragma once

#include "settings/InkSettings.h"

namespace dipwright {

// One ink's law. All densities are passed as natural logarithms; −∞ stands for density 0. For
// white, the share of the background that the ink hides replaces the density. Const members may be
// used from several threads.
class Thinning {
public:
    Thinning(const InkLaw& law, FilmInk ink);

    // Return printed density divided by shown density where the film's area has grown by
    // `areaStretch`, above 0. byShown() takes the density that should show, byPrinted() the printed
    // density.
    float byShown(float shown, float areaStretch) const;
    float byPrinted(float printed, float areaStretch) const;

private:
    struct Tone {
        float density, exponent, bend, mostGrown; // logarithms, except exponent and bend
    };
    float shownAt(const Tone& tone, float grown) const;
    float layerThinning(float areaStretch) const;

    float exponent_;
    std::vector<Tone> tones_;
};

} // namespace dipwright
