// Colours that sRGB does not hold. Textures and film images are sRGB in eight bits
// (Format_RGBA8888), or, where that would lose colour, wide: the primaries of Rec. ITU-R BT.2020 in
// sixteen bits (Format_RGBA64; RGBX64 where opaque), with sRGB's white and curve. These hold all of
// Adobe RGB and Display P3, and next to all that inks can show. All functions are reentrant.
#pragma once

#include <QColorSpace>
#include <QImage>
#include <array>

namespace dipwright {

// What weights of the linear red, green and blue of one make those of the other, a row each
// (derived from the chromaticities of the primaries, BT.2020 and IEC 61966-2-1, and of D65).
using LightWeights = std::array<std::array<double, 3>, 3>;
inline constexpr LightWeights wideToSrgbLight{{{1.6604910, -0.5876411, -0.0728499},
                                               {-0.1245505, 1.1328999, -0.0083494},
                                               {-0.0181508, -0.1005789, 1.1187297}}};
inline constexpr LightWeights srgbToWideLight{{{0.6274039, 0.3292830, 0.0433131},
                                               {0.0690973, 0.9195404, 0.0113623},
                                               {0.0163915, 0.0880133, 0.8955952}}};

bool isWide(const QImage& picture);
QColorSpace wideSpace();

// A wide picture in sRGB, what that does not hold at its nearest there, channel by channel; alpha
// stays, RGBA8888 or RGB888. Any other picture comes back as it is.
QImage inSrgb(const QImage& picture);
// A picture in sRGB as a wide one, RGBA64. A wide one comes back as it is.
QImage inWide(const QImage& picture);
// Whether sRGB in eight bits shows every pixel of a wide picture: none is more than a step beyond
// its ends.
bool isHeldBySrgb(const QImage& wide);

} // namespace dipwright
