// Fits how ink thins on stretched film (docs/film-model.md, "Ink").
//
// An even layer, such as a dye, follows Beer–Lambert: where the film's area has grown by J, the
// printed density P shows as P/J. Printed dots stretch with the film and cover the same share of it
// as before. Their density therefore exceeds P/J, and the excess depends on P. So the law is
// P·J^−n, with one n per ink, or one n per tone if a step wedge was read.
#pragma once

#include "settings/InkSettings.h"

#include <QString>
#include <span>

namespace dipwright {

// One patch of a step wedge, read before and after the film was stretched.
struct WedgeReading {
    FilmInk ink = FilmInk::Cyan;
    double nominal = 0; // density that the wedge page specifies
    double flat = 0;    // density read on unstretched film
    double stretch = 1; // growth J of the area, above 1
    double shown = 0;   // density read on the stretched film
    int line = 0;       // line of the table with this reading; 0: none
};

// A fitted law and how well it fits.
struct FittedInk {
    InkLaw law;
    int patches = 0;
    double worst = 0; // largest difference in density between a reading and the law
};
// Fits one tone to the readings of each patch by least squares. Inks without readings keep the
// exponent 1. Throws Error, naming `where` and the line of a wrong reading, if the readings are too
// few or impossible for ink.
FittedInk fitInk(std::span<const WedgeReading> readings, const QString& where);

} // namespace dipwright
