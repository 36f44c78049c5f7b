// Which pixels of a sheet's film get ink, of whatever plate.
#pragma once

#include "sheet/page/Sheet.h"

namespace dipwright {

// What of a sheet counts as printed: its picture alone, as on a printer of RGB, or all plates as on
// a printer of inks, white and spot inks included.
enum class InkedPlates { Picture, All };

// A mask of a part of the film image, in its pixels: 255 where it gets ink, else 0. Grayscale8. All
// cores.
QImage inkedPixels(const Sheet& sheet, const QRect& part, InkedPlates plates = InkedPlates::All);

// The smallest box of the film image with all inked pixels; invalid where there are none.
QRect inkedBox(const Sheet& sheet, InkedPlates plates = InkedPlates::All);

} // namespace dipwright
