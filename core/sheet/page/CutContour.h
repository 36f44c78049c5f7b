// Makes the line along which the printed film is cut.
#pragma once

#include "sheet/page/SheetLayout.h"

#include <QPainterPath>

namespace dipwright {

// Returns closed paths on the page, in mm. The settings choose between the film's edge (with
// several jobs, the edge of each piece) and a line round the ink. The line round the ink keeps the
// settings' distance from all plates, white and spot inks included. It stays within the film and
// does not cut out holes. The result is empty if the settings ask for no line or nothing is
// printed.
QPainterPath cutContour(const Sheet& sheet, const SheetLayout& layout);

// Returns how far, in mm, the line round the ink and the bleed past it reach from the ink. 0 if the
// settings ask for no line round the ink.
double cutReach(const SheetSettings& settings);

} // namespace dipwright
