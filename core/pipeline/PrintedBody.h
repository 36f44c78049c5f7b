// Gives proofs and views the appearance of a dipped body.
#pragma once

#include "pipeline/JobResult.h"
#include "results/Results.h"

namespace dipwright {

// Returns the film of each dip with its picture and spot colours, and its white layer if `white`.
std::vector<FilmAppearance> filmAppearances(const std::vector<ImmersionResult>& immersions,
                                            bool white);

// Returns the ground below the ink. `baseColour`: the body's own colour "#rrggbb", or empty.
Ground groundOf(const SheetSettings& sheet, const QString& baseColour);

} // namespace dipwright
