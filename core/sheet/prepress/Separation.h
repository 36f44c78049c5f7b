// Separates a sheet's film into a printer's inks, as every CMYK page needs it.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/Plates.h"

namespace dipwright {

// Separates the sheet's film on white paper into the inks of `correction`, within its limit of
// total area coverage, and into the sheet's spot inks. The colour of `correction` must be CMYK. If
// the sheet has the film's stretch, the wanted colours are separated first, and then each ink is
// compensated by its own law (PlateCompensation). Uses all cores.
Plates separate(const Sheet& sheet, const PrintCorrection& correction);

// Returns the area of the part, in mm², where the inks stay visibly paler than wanted: full ink
// does not compensate the stretch, or one of the two ink limits prevents it. 0 if the sheet does
// not have the film's stretch.
double inkShortfall(const Sheet& sheet, const PrintCorrection& correction);

// Returns bare paper in these inks, as it surrounds the film.
std::array<char, 4> bareInks(const PrinterColour& colour);

// Returns the plate without the pixels nearer than `choke` pixels to a pixel without tint.
// Grayscale8.
QImage choked(const QImage& tint, double choke);

// Reduces pixels whose four inks sum to more than `most` (4: full ink of each). Cyan, magenta and
// yellow are scaled by one factor, which keeps the hue. Black is reduced only if it exceeds `most`
// alone, because it gives the most darkness for the least ink.
void limitInk(QByteArray& cmyk, double most);

} // namespace dipwright
