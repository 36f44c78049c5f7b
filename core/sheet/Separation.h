// The picture on a film in a printer's inks: all that a CMYK page is made of, whatever file it
// stands in.
#pragma once

#include "sheet/Plates.h"
#include "sheet/Sheet.h"

namespace dipwright {

// A film image on white paper, in the inks of `correction`, whose colour must be in CMYK, and
// within its total of ink. All cores.
Plates separate(const QImage& filmImage, const PrintCorrection& correction);

// The sheet's white as far as it has one, in the film image's pixels.
SpotPlates spotPlates(const Sheet& sheet);

// A plate without what lies nearer than `choke` pixels to a place without tint. Grayscale8.
QImage choked(const QImage& tint, double choke);

// Takes ink off pixels that have more than `most` of all four together (4: full ink of each): cyan,
// magenta and yellow by one factor, which keeps the hue, and black only where it alone is
// more. Black stands for most of the darkness at the least ink.
void limitInk(QByteArray& cmyk, double most);

} // namespace dipwright
