// Finds the pixels of a sheet's film that get ink from any plate.
#pragma once

#include "sheet/page/Sheet.h"

namespace dipwright {

// Which plates count as ink: the picture alone, as on an RGB printer, or all plates, white and spot
// inks included.
enum class InkedPlates { Picture, All };

// Returns a mask of a part of the film image, in its pixels: 255 where it gets ink, else 0.
// Grayscale8. Uses all cores.
QImage inkedPixels(const Sheet& sheet, const QRect& part, InkedPlates plates = InkedPlates::All);

// Returns the smallest box of the film image that contains all inked pixels; invalid if there are
// none.
QRect inkedBox(const Sheet& sheet, InkedPlates plates = InkedPlates::All);

} // namespace dipwright
