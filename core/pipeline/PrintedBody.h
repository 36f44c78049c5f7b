// Gives proofs and views the appearance of a dipped body.
#pragma once

#include "pipeline/JobResult.h"
#include "results/Results.h"

namespace dipwright {

// Returns the film of each dip with its picture and spot colours. Includes the white layer if
// `white` is true.
std::vector<FilmAppearance> filmAppearances(const std::vector<ImmersionResult>& immersions,
                                            bool white);

// Returns the surface below the ink. `baseColour` is the body's own colour as "#rrggbb", or empty.
Ground groundOf(const SheetSettings& sheet, const QString& baseColour);

// Draws the part of a finished result as it will come out, from the side where most of its paint
// is. `size` is in pixels. Uses all cores. Throws Cancelled.
QImage portraitOf(const JobResult& result, QSize size, const CancelToken& cancelToken);

} // namespace dipwright
