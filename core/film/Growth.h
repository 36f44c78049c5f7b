// How floating film grows with time (docs/film-model.md, "Swell, relaxation and edges").
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright {

// Whether floating film grows with these settings.
bool grows(const solver::Settings& settings);
// Returns the length of freely floating film after `seconds`, relative to its length at the start
// of the dip; 1 if the film does not grow.
double grownLength(double seconds, const solver::Settings& settings);

} // namespace dipwright
