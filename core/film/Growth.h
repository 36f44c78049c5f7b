// How floating film grows with time (docs/film-model.md, "Swell, relaxation and edges").
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright {

bool grows(const solver::Settings& settings);
// How many times as long as when the dip began film is, left to itself, after so many seconds. 1
// where it does not grow.
double grownLength(double seconds, const solver::Settings& settings);

} // namespace dipwright
