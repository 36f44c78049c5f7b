// Formats numbers for the user, in millimetres or inches, with their unit.
#pragma once

#include "base/Units.h"
#include "workbench/document/Preferences.h"

#include <Eigen/Core>

namespace dipwright {

// The factor from a project's value to the shown value.
double shownPerStored(Unit unit, LengthUnit length);
QString unitSuffix(Unit unit, LengthUnit length); // " mm", with the leading space
// The number of decimals that resolves one `step` of a stored value.
int unitDecimals(Unit unit, LengthUnit length);
// "12.50 mm"; `moreDecimals` are for small differences.
QString shownLength(double millimetres, LengthUnit length, int moreDecimals = 0);
// "120 mm²" or "0.186 in²".
QString shownArea(double squareMillimetres, LengthUnit length);
// A place in model coordinates, in mm: "1.2, 3.4, 5.6 mm".
QString shownPlace(const Eigen::Vector3f& place, LengthUnit length);
QString shownNumber(double value, Unit unit, LengthUnit length, int moreDecimals = 0);
// Returns the text with each number and its unit kept on one line.
QString withUnitsKept(QString text);

} // namespace dipwright
