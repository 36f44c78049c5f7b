// ICC profiles for tests, made with lcms2: no files, the same everywhere.
#pragma once

#include <QByteArray>

namespace dipwright {

// An RGB printer whose red, green and blue are pale (half-way to the white point from sRGB's).
QByteArray paleRgbProfile();
// A CMYK printer with simple inks: light = (1 − ink)·(1 − black), in sRGB's primaries, and no black
// generation. `leastLight`: of a channel under full ink.
QByteArray simpleCmykProfile(double leastLight);

} // namespace dipwright
