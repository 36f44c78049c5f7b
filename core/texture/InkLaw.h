// How ink thins on film that stretches (docs/film-model.md, "Ink").
//
// An even layer, as of a dye, keeps Beer–Lambert: where the film's area has grown by J the printed
// density P shows as P/J. Dots that stretch with the film cover as much of it as before and show
// more; how much more hangs on how dense they are. So the law is P·J^−n, with an n for each ink,
// and where a step wedge was read, for each of its tones.
#pragma once

#include "settings/InkSettings.h"

#include <QString>
#include <span>

namespace dipwright {

// A patch of a step wedge, read before the film was stretched and after.
struct WedgeReading {
    FilmInk ink = FilmInk::Cyan;
    double nominal = 0; // density that the page asked for
    double flat = 0;    // density that unstretched film shows
    double stretch = 1; // J, above 1
    double shown = 0;   // density
};

struct FittedInk {
    InkLaw law;
    int patches = 0;
    double worst = 0; // of density: the farthest that a reading is from the law
};
// A tone for each patch by least squares over its stretches; inks that were not read keep the
// exponent 1. Throws Error, with `where`, on readings that no ink gives, and on too few.
FittedInk fitInk(std::span<const WedgeReading> readings, const QString& where);

} // namespace dipwright
