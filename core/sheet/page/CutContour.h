// Makes the line along which the printed film is cut. Private to this folder.
#pragma once

#include "sheet/page/SheetLayout.h"

#include <QPainterPath>

namespace dipwright {

// Returns closed paths on the page, in mm. The settings choose between the film's edge (with
// several jobs, the edge of each piece) and a line round the ink. That line keeps the settings'
// distance from the ink of all plates, white and spot inks included. It stays within the film and
// does not cut out holes. Empty if no line is asked for or nothing is printed.
QPainterPath cutContour(const Sheet& sheet, const SheetLayout& layout);

} // namespace dipwright
