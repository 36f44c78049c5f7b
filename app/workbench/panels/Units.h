// Numbers as the user reads them: in millimetres or inches, with the unit's sign.
#pragma once

#include "document/Preferences.h"

namespace dipwright {

enum class Unit {
    None,
    Length,
    Speed,
    Time,
    Angle,
    Resolution,
    Ratio,
    Cells,
    Density,
    Share,
    ShareRate
};

// The factor from a project's value to the one shown.
double shownPerStored(Unit unit, LengthUnit length);
QString unitSuffix(Unit unit, LengthUnit length); // " mm", with the space before it
// Decimals that show `step` of a stored value.
int unitDecimals(Unit unit, LengthUnit length);
// "12.50 mm"; with more decimals where small differences count.
QString shownLength(double millimetres, LengthUnit length, int moreDecimals = 0);
QString shownNumber(double value, Unit unit, LengthUnit length, int moreDecimals = 0);

} // namespace dipwright
