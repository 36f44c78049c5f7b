// The line along which a printed film is cut. Private to this folder.
#pragma once

#include "sheet/page/SheetLayout.h"

#include <QPainterPath>

namespace dipwright {

// On the page, mm, closed: the film's own edge, of several jobs that of each piece, or round the
// ink of all plates, white and spot inks too, at the settings' distance, within the film, holes
// left in. Empty where no line is asked for or nothing is printed.
QPainterPath cutContour(const Sheet& sheet, const SheetLayout& layout);

} // namespace dipwright
