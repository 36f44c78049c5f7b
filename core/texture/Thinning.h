// Evaluates one ink's law (texture/InkLaw.h) fast enough for every pixel.
#pragma once

#include "settings/InkSettings.h"

namespace dipwright {

// Densities here are natural logarithms of densities, −∞ for none. For white, the hiding share
// takes the place of the density. Const members may be used from several threads.
class Thinning {
public:
    Thinning(const InkLaw& law, FilmInk ink);

    // Return printed density over shown density where the film's area has grown by `areaStretch`,
    // above 0. byShown() starts from the density that should show, byPrinted() from the printed
    // one.
    float byShown(float shown, float areaStretch) const;
    float byPrinted(float printed, float areaStretch) const;

private:
    struct Tone {
        float density, exponent, bend, mostGrown; // logarithms, except exponent and bend
    };
    float shownAt(const Tone& tone, float grown) const;
    float ofLayer(float areaStretch) const;

    float exponent_;
    std::vector<Tone> tones_;
};

} // namespace dipwright
