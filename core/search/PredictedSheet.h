// Predicts from two coarse dips of a pose how much work the job needs until its sheet can be
// printed (docs/pose-search.md, "Certain sheets"). Private to this folder.
#pragma once

#include "accuracy/verdict/Verdict.h"
#include "film/DippedFilm.h"
#include "settings/ToleranceSettings.h"

#include <vector>

namespace dipwright {

// How far a place of the flat film moves between two dips, and the zone that it paints.
struct PlaceMove {
    float distance; // mm
    Zone zone;
};

// The smallest cells, in mm, of the films of two dips that are compared, and of the film with which
// the job would begin; 0: not known.
struct ComparedCells {
    double coarse = 0, finer = 0, job = 0;
};

struct PredictedSheet {
    // By everything but the numerical error; NotJudged: nothing is predicted.
    Advice advice = Advice::NotJudged;
    // How often the work of the job's first dip has to be doubled until the numerical error is
    // small enough to print the sheet; 0 if it is small enough already.
    double doublings = 0;
};

// More doublings mean only that the cells are far from sufficient; they count as this number.
inline constexpr double mostDoublings = 12;

// Returns PredictedSheet::doublings. `moves` are the moves from the coarse to the finer film at
// evenly spread places that both paint. Returns 0 if the films tell nothing: if their cells are
// nearly equal, or no place is painted.
double predictedDoublings(const std::vector<PlaceMove>& moves, const ComparedCells& cells,
                          const ToleranceSettings& tolerance);

// Returns the same number by the verdict on the job's first dip, afterRefinement(). Without
// Kind::Refined, it is the number for the cells that the verdict proposes; for an error too large
// to propose any, the number for an error of first order. Returns 0 if the verdict finds no
// numerical error that is too large.
double neededDoublings(const Verdict& verdict, const DippedFilm& film);

} // namespace dipwright
