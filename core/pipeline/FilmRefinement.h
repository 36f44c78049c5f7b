// Chooses smaller cells for a film if its numerical error keeps its sheet from being printed.
//
// A dip with automatic cells begins with the cells that suit its body. While the numerical error
// keeps its sheet from being printed, the dip is repeated with smaller cells. It ends when the
// sheet can be printed, or when the next dip would need more work than the film's settings allow.
// The work is points × steps, so every computer stops at the same cells. Each choice depends only
// on the previous dip and its numerical error, so a job that was stopped can continue from there.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// Returns the refinement (FilmSettings::refinement) with which the dip is to be repeated. It
// follows from finerCell(). None if the sheet can be printed as it is and has the wanted error
// (FilmSettings::wantedError), if smaller cells do not help, if the limits do not allow them, or if
// a dip with smaller cells failed. `verdict` is the verdict on the dip, or the part of it that is
// about the numerical error (numericalVerdict()).
std::optional<double> nextRefinement(const ImmersionResult& dip, const Verdict& verdict,
                                     const FilmSettings& settings);

// Returns the film settings of a dip: the project's, with the cells that were used.
FilmSettings filmOf(const ImmersionResult& dip, const Project& project);

// Returns sentences for the user: which dips were refined. The user need not do anything.
QStringList refinementRemarks(const JobResult& result);
// Returns these sentences and those about what would need more work.
QStringList refinementNotes(const JobResult& result);

} // namespace dipwright
