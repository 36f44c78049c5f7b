// Gives proofs and views the appearance of a dipped body.
#pragma once

#include "pipeline/JobResult.h"
#include "results/PaintedBody.h"

namespace dipwright {

// Returns the film of each dip with its picture and spot colours. Includes the white layer if
// `white` is true.
std::vector<FilmAppearance> filmAppearances(const std::vector<ImmersionResult>& immersions,
                                            bool white);

// Returns the surface below the ink. `baseColour` is the body's own colour as "#rrggbb", or empty.
Ground groundOf(const SheetSettings& sheet, const QString& baseColour);

// Returns the part as it comes out of the first `count` dips of a finished job. Places refer to
// `fine`, a refined mesh of the model, which must outlive the result; about `places` of them will
// be asked for. Uses all cores.
PaintedBody printedBody(const JobResult& result, std::size_t count, const RefinedMesh& fine,
                        double places = std::numeric_limits<double>::infinity());

// Draws the part of a finished result as it will come out, from the side where most of its paint
// is. `size` is in pixels. Uses all cores. Throws Cancelled.
QImage portraitOf(const JobResult& result, QSize size, const CancelToken& cancelToken);

} // namespace dipwright
