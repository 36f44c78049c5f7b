// Computes the form of a cradle on a grid.
#pragma once

#include "cradle/CradlePlate.h"
#include "cradle/FilmSide.h"
#include "geometry/DistanceField.h"

namespace dipwright {

// Distances in mm that a cradle keeps from surfaces. They also apply to the space that a surface
// sweeps when the body moves down and out.
struct CradleDistances {
    double body = 0;         // distance from the whole body
    double earlierPaint = 0; // distance from FilmSide::earlierPaint
    double film = 0;         // distance from FilmSide::film
    double outer = 0;        // farthest distance of material from the body
    double lowest = 0;       // y below which there is no material
};

// Returns a field that is negative in the cradle. Near the surface, a value is about the distance
// from the surface, mm. `cell` is the grid's spacing. The grid extends past the cradle on all
// sides. Uses all cores; deterministic. Throws Cancelled.
DistanceField cradleForm(const HeldDip& dip, const CradleSettings& settings, const FilmSide& side,
                         const CradlePlate& plate, const CradleDistances& distances, double cell,
                         const Progress& progress);

// Returns roughly the number of samples of the grid of cradleForm().
double formSamples(const CradlePlate& plate, double lowest, double cell);

} // namespace dipwright
