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

// Returns the cell, in mm, that is needed to print the sheet or, if it can be printed, to reach the
// wanted error (FilmSettings::wantedError); none if the film's own cell is small enough. `offBy` is
// the film's numerical error (95th percentile, mm), assumed to be of first order.
std::optional<double> neededCell(const Verdict& verdict, const DippedFilm& film, double offBy,
                                 const FilmSettings& settings);

// Returns a proposed cell, in mm, as texts show it: rounded down to hundredths, because a larger
// cell would not suffice.
double cellToSet(double cell);

// Returns the smallest cell that the limits of work and of points allow, in mm. If the cells shrink
// by a factor, the number of points grows by its square. The number of steps grows by the factor
// itself, because the length of a step is given in cells.
double smallestCell(const DippedFilm& film, const FilmSettings& settings);

// Returns the cell with which the dip is to be repeated, in mm; none if the film keeps its cell.
// The cell is at most `wanted`. With it, the work doubles a whole number of times. If the limits do
// not allow this cell, returns the smallest one that they allow and for which the work doubles a
// whole number of times.
std::optional<double> finerCell(double wanted, const DippedFilm& film,
                                const FilmSettings& settings);

// Returns the refinement (FilmSettings::refinement) with which a dip is to be repeated, by
// neededCell() and finerCell(); none if its film keeps its cells. `refinement` is the film's own.
std::optional<double> nextRefinement(const Verdict& verdict, const DippedFilm& film, double offBy,
                                     double refinement, const FilmSettings& settings);

// Returns the verdict to be expected after the job has refined the film. If the settings allow
// wantedCell(), Kind::Refined replaces the reasons about the numerical error.
Verdict afterRefinement(Verdict verdict, const DippedFilm& film, const FilmSettings& settings);

} // namespace dipwright
