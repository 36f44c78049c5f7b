// The form of a cradle on a grid: what is cut away and what stays.
#pragma once

#include "cradle/CradlePlate.h"
#include "cradle/FilmSide.h"
#include "geometry/DistanceField.h"

namespace dipwright {

// Distances in mm that a cradle keeps, each from the surface and from everywhere that the surface
// passes when the body is taken out downwards.
struct CradleDistances {
    double body = 0;         // from all of the body
    double earlierPaint = 0; // from FilmSide::earlierPaint
    double film = 0;         // from FilmSide::film
    double outer = 0;        // and up to where there is material beside the body
    double lowest = 0;       // y under which there is none
};

// Negative in the cradle, mm, near its surface about the distance from it. `cell`: the grid's
// spacing. The grid reaches past the cradle on all sides. All cores; deterministic.
DistanceField cradleForm(const HeldDip& dip, const CradleSettings& settings, const FilmSide& side,
                         const CradlePlate& plate, const CradleDistances& distances, double cell,
                         const Progress& progress);

// How many samples such a grid has.
double formSamples(const CradlePlate& plate, double lowest, double cell);

} // namespace dipwright
