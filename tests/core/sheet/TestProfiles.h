// Makes ICC profiles for tests with lcms2, without files.
#pragma once

#include <QByteArray>

namespace dipwright {

// An RGB printer with pale red, green and blue: halfway from sRGB's primaries to the white point.
QByteArray paleRgbProfile();
// A CMYK printer with simple inks: light = (1 − ink)·(1 − black), in sRGB's primaries, and no black
// generation. `leastLight`: the light of a channel under full ink.
QByteArray simpleCmykProfile(double leastLight);

} // namespace dipwright
