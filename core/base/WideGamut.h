// Colours outside sRGB. Textures and film images are sRGB in eight bits (Format_RGBA8888). Pictures
// that would lose colour in sRGB are *wide*: they use the primaries of Rec. ITU-R BT.2020 in
// sixteen bits (Format_RGBA64; RGBX64 if opaque), with sRGB's white point and transfer curve. Wide
// pictures hold all of Adobe RGB and Display P3, and nearly all colours of inks. All functions are
// reentrant.
#pragma once

#include <QColorSpace>
#include <QImage>
#include <array>

namespace dipwright {

// Matrices that convert linear red, green and blue between the two spaces. Each row gives one
// resulting channel. Derived from the chromaticities of the primaries (BT.2020 and IEC 61966-2-1)
// and of D65.
using LightWeights = std::array<std::array<double, 3>, 3>;
inline constexpr LightWeights wideToSrgbLight{{{1.6604910, -0.5876411, -0.0728499},
                                               {-0.1245505, 1.1328999, -0.0083494},
                                               {-0.0181508, -0.1005789, 1.1187297}}};
inline constexpr LightWeights srgbToWideLight{{{0.6274039, 0.3292830, 0.0433131},
                                               {0.0690973, 0.9195404, 0.0113623},
                                               {0.0163915, 0.0880133, 0.8955952}}};

// Converts an encoded value of a channel to linear light, by the curve that sRGB and wide pictures
// share (IEC 61966-2-1).
double linearFromSrgb(double encoded);

bool isWide(const QImage& picture);
QColorSpace wideSpace();

// Converts a wide picture to sRGB. Colours outside sRGB are clipped channel by channel. Alpha is
// kept: the result is RGBA8888 or RGB888. Returns any other picture unchanged.
QImage inSrgb(const QImage& picture);
// Converts a picture from sRGB to a wide one (RGBA64). Returns a wide picture unchanged.
QImage inWide(const QImage& picture);
// Whether eight-bit sRGB can hold every pixel of a wide picture. A pixel may lie outside the range
// of sRGB by one step of the eight bits.
bool fitsInSrgb(const QImage& wide);

} // namespace dipwright
