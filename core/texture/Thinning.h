// One ink's law (texture/InkLaw.h), ready to be asked for every pixel.
#pragma once

#include "settings/InkSettings.h"

namespace dipwright {

// Densities here are natural logarithms of densities, −∞ for none; of white, of the share that it
// hides. Const members may be used from several threads.
class Thinning {
public:
    Thinning(const InkLaw& law, FilmInk ink);

    // Printed density over the shown one where the film's area has grown by `areaStretch`, above 0:
    // by the density that is to show, and by the printed one.
    float byShown(float shown, float areaStretch) const;
    float byPrinted(float printed, float areaStretch) const;

private:
    struct Tone {
        float density, exponent, bend, mostGrown; // all but exponent and bend as logarithms
    };
    float shownAt(const Tone& tone, float grown) const;
    float ofLayer(float areaStretch) const;

    float exponent_;
    std::vector<Tone> tones_;
};

} // namespace dipwright
