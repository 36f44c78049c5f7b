// Draws where the sheets of two dips differ (accuracy/error/SheetDifference.h).
#pragma once

#include "base/Units.h"
#include "dip/LaidFilm.h"

#include <QColor>
#include <QImage>

namespace dipwright {

// The colour of places that only one of two compared dips paints. No colour map is as dark.
inline const QColor paintedOnceColour(0, 0, 0);

// Returns the end of a scale from 0 that includes nearly all moves, in mm: a round number in
// `unit`. Negative values and NaN do not count.
double differenceScaleEnd(std::vector<float> moves, LengthUnit unit);

// Draws how far each film point moves on the flat film, like numericalErrorMap() in Results.h.
// `moves` are in mm; NaN: only this dip paints the body there. The scale ends at `scaleEnd` (mm);
// higher values have a colour of their own.
QImage differenceMap(const LaidFilm& laid, const std::vector<float>& moves, double scaleEnd,
                     int longEdge, LengthUnit unit = LengthUnit::Millimetre);

} // namespace dipwright
