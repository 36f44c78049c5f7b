// How much a sheet depends on one of the laws that no measurement stands behind
// (docs/film-model.md, "Constants of ours").
#pragma once

#include "accuracy/certainty/SheetChange.h"

#include <functional>

namespace dipwright {

// What a sheet changes when such a law's value is varied to either side.
struct LawChange {
    QString setting;                      // its path in the project: "process.overhang_deg"
    double value = 0, less = 0, more = 0; // as set, and what it was varied to
    // mm: the larger move of both, over points spread evenly over the body that all three paint.
    Distribution distance;
    // Of the painted area, each with one of the variations at least:
    double moved = 0; // moves by more than a certain sheet does (certainHalfSpacing)
    double lost = 0;  // is not painted any more

    double dependent() const { return moved + lost; } // no place is both
};

// Fills in what is measured. The films are of one body in one pose. All cores, deterministic.
void measureLaw(LawChange& change, const LaidFilm& own, const LaidFilm& less, const LaidFilm& more);

// For the user: "Overhang, 16 to 24 in place of 20: …". `length` words a length given in mm.
QString lawText(const LawChange& change, const std::function<QString(double)>& length);

} // namespace dipwright
