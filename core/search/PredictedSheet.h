// Predicts from two coarse dips of a pose how much work the job needs until its sheet can be
// printed (docs/pose-search.md, "Certain sheets"). Private to this folder.
#pragma once

#include "settings/ToleranceSettings.h"
#include "settings/VerdictSettings.h"

#include <cstddef>
#include <vector>

namespace dipwright {

// The cells of a film, and the work of a dip with it.
struct FilmWork {
    double cell = 0; // the smallest, mm; 0: not known
    double work = 0; // film points × steps, in millions
};
double workOf(std::size_t points, double steps);

// How far a place of the flat film moves between two dips, and the zone that it paints.
struct PlaceMove {
    float distance; // mm
    Zone zone;
};

// The films of two dips that are compared, and the film with which the job would begin.
struct ComparedFilms {
    FilmWork coarse, finer, job;
};

struct PredictedSheet {
    // By everything but the numerical error; NotJudged: nothing is predicted.
    Advice advice = Advice::NotJudged;
    // How often the work of the job's first dip has to be doubled until the numerical error is
    // small enough to print the sheet; 0 if it is small enough already.
    double doublings = 0;
};

// Returns PredictedSheet::doublings. `moves` are the moves from the coarse to the finer film at
// evenly spread places that both paint. Returns 0 if the films tell nothing: if their cells are
// nearly equal, or no place is painted.
double predictedDoublings(const std::vector<PlaceMove>& moves, const ComparedFilms& films,
                          const ToleranceSettings& tolerance);

} // namespace dipwright
