// How a body wears what its dips have given it, for proofs and views.
#pragma once

#include "pipeline/JobResult.h"
#include "results/Results.h"

namespace dipwright {

// The film of each dip with its picture and its spot inks, and with its white where that is to be
// seen.
std::vector<FilmAppearance> filmAppearances(const std::vector<ImmersionResult>& immersions,
                                            bool white);

// What the ink is seen on, of a body of `baseColour` ("#rrggbb"; empty: none of its own).
Ground groundOf(const SheetSettings& sheet, const QString& baseColour);

} // namespace dipwright
