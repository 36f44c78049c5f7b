// The picture on a film in a printer's inks: all that a CMYK page is made of, whatever file it
// stands in.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/Plates.h"

namespace dipwright {

// A sheet's film on white paper, in the inks of `correction`, whose colour must be in CMYK, within
// its total of ink, and in the sheet's spot inks. Where the sheet says how its film stretches, what
// is to show is separated and then each ink compensated by its own law (PlateCompensation.h). All
// cores.
Plates separate(const Sheet& sheet, const PrintCorrection& correction);

// mm² of the part where the inks do not show what they were to: where full ink does not make up for
// the stretch, or the total of ink or the ink limit does not let it. 0 for sheets that do not say
// how their film stretches.
double inkShortfall(const Sheet& sheet, const PrintCorrection& correction);

// Bare paper in these inks: what is round the film.
std::array<char, 4> bareInks(const PrinterColour& colour);

// A plate without what lies nearer than `choke` pixels to a place without tint. Grayscale8.
QImage choked(const QImage& tint, double choke);

// Takes ink off pixels that have more than `most` of all four together (4: full ink of each): cyan,
// magenta and yellow by one factor, which keeps the hue, and black only where it alone is
// more. Black stands for most of the darkness at the least ink.
void limitInk(QByteArray& cmyk, double most);

} // namespace dipwright
