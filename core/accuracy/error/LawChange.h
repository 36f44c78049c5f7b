// Tells how much a sheet depends on one film law that was assumed, not measured
// (docs/film-model.md, "Assumed constants").
#pragma once

#include "accuracy/error/SheetChange.h"

#include <functional>

namespace dipwright {

// How a sheet changes when the value of a law is decreased and increased.
struct LawChange {
    QString setting;                      // path in the project: "process.overhang_deg"
    double value = 0, less = 0, more = 0; // the value in use, and the two variations
    // Distribution, in mm, over evenly spread points that all three films paint. Each point counts
    // with the larger of its two moves.
    Distribution distance;
    // Shares of the painted area on which at least one of the variations has this effect:
    double moved = 0; // the place moves farther than mostHalfSpacingChange
    double lost = 0;  // the place is no longer painted; it does not count as moved
};

// Fills in `distance`, `moved` and `lost`. All films belong to one body in one pose. Uses all
// cores; deterministic.
void measureLaw(LawChange& change, const LaidFilm& own, const LaidFilm& less, const LaidFilm& more);

// Returns a sentence for the user: "Overhang (°) varied from 16 to 24 …". `length` formats mm.
QString lawText(const LawChange& change, const std::function<QString(double)>& length);

} // namespace dipwright
