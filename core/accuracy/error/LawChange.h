// Tells how much a sheet depends on one film law that was assumed, not measured
// (docs/film-model.md, "Assumed constants").
#pragma once

#include "accuracy/numericalError/SheetChange.h"

#include <functional>

namespace dipwright {

// How a sheet changes when the value of a law is decreased and increased.
struct LawChange {
    QString setting;                      // path in the project: "process.overhang_deg"
    double value = 0, less = 0, more = 0; // the value in use, and the two variations
    // The larger of both moves in mm, over evenly spread points that all three films paint.
    Distribution distance;
    // Shares of the painted area for which at least one variation has this effect:
    double moved = 0; // moves farther than the limit mostHalfSpacingChange
    double lost = 0;  // is no longer painted

    double dependent() const { return moved + lost; } // no place counts in both
};

// Fills in the measured values. The films are of one body in one pose. All cores, deterministic.
void measureLaw(LawChange& change, const LaidFilm& own, const LaidFilm& less, const LaidFilm& more);

// A sentence for the user: "Overhang (°) varied from 16 to 24 …". `length` formats mm.
QString lawText(const LawChange& change, const std::function<QString(double)>& length);

} // namespace dipwright
