// Chooses smaller cells for a film whose numerical error is too large to print its sheet
// (docs/film-validation.md, "The verdict").
#pragma once

#include "accuracy/verdict/Verdict.h"
#include "settings/FilmSettings.h"

namespace dipwright {

// Returns the film cell, in mm, with which the sheet may be good enough to print: the cell that the
// verdict proposes, or half the present one if it proposes none. None if the numerical error is
// small enough.
std::optional<double> wantedCell(const Verdict& verdict, const DippedFilm& film);

// Returns the smallest cell that the limits of work and of points allow, in mm. Points grow with
// the square of the refinement; steps, which are given in cells, in proportion to it.
double smallestCell(const DippedFilm& film, const FilmSettings& settings);

// Returns the cell with which the dip is to be repeated, in mm; none if it stays as it is. This is
// at most wantedCell(), and such that the work doubles a whole number of times, so that small
// differences between solvers rarely lead to other cells. If the limits do not allow it, it is the
// smallest such cell that they allow.
std::optional<double> finerCell(const Verdict& verdict, const DippedFilm& film,
                                const FilmSettings& settings);

// Returns the verdict to be expected after the job has refined the film. If the settings allow
// wantedCell(), Kind::Refined replaces the reasons about the numerical error.
Verdict afterRefinement(Verdict verdict, const DippedFilm& film, const FilmSettings& settings);

} // namespace dipwright
