// Finds the pixels of a sheet's film that get ink from any plate.
#pragma once

#include "sheet/page/Sheet.h"

namespace dipwright {

// Which plates count as ink: only the picture, as on an RGB printer, or all plates, including white
// and spot inks.
enum class InkedPlates { Picture, All };

// Returns a mask of a part of the film image, pixel by pixel: 255 where there is ink, else 0.
// Grayscale8. Uses all cores.
QImage inkedPixels(const Sheet& sheet, const QRect& part, InkedPlates plates = InkedPlates::All);

// Calls work(mask, first) for the masks of all rows of the film, in bands from top to bottom.
// `first` is the number of the band's first row.
void forInkedPixels(const Sheet& sheet, InkedPlates plates,
                    const std::function<void(const QImage& mask, int first)>& work);

// Returns which share of a box on the page, in mm, gets ink from any plate. `film` is the film's
// place on the page.
double inkedShare(const Sheet& sheet, const QRectF& film, const QRectF& box);

// Returns the smallest box of the film image that contains all inked pixels; invalid if there are
// none.
QRect inkedBox(const Sheet& sheet, InkedPlates plates = InkedPlates::All);
// Returns the smallest box of all pixels above 0 in a Grayscale8 picture; invalid if there are
// none.
QRect markedBox(const QImage& mask);

} // namespace dipwright
