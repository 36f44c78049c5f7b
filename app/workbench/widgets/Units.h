// Numbers as the user reads them: in millimetres or inches, with the unit's sign.
#pragma once

#include "base/Units.h"
#include "workbench/document/Preferences.h"

#include <Eigen/Core>

namespace dipwright {

// The factor from a project's value to the one shown.
double shownPerStored(Unit unit, LengthUnit length);
QString unitSuffix(Unit unit, LengthUnit length); // " mm", with the space before it
// Decimals that show `step` of a stored value.
int unitDecimals(Unit unit, LengthUnit length);
// "12.50 mm"; with more decimals where small differences count.
QString shownLength(double millimetres, LengthUnit length, int moreDecimals = 0);
// "120 mm²" or "0.186 in²", of square millimetres.
QString shownArea(double squareMillimetres, LengthUnit length);
// A place of the model, mm: "1.2, 3.4, 5.6 mm".
QString shownPlace(const Eigen::Vector3f& place, LengthUnit length);
QString shownNumber(double value, Unit unit, LengthUnit length, int moreDecimals = 0);

} // namespace dipwright
