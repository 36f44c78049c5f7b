// Converts between pixel values and linear light, in which pictures are filtered and ink is
// computed. Pixels have eight bits in sRGB or sixteen in wide colour (base/WideGamut.h).
#pragma once

#include "base/WideGamut.h"

#include <Eigen/Core>
#include <QColor>
#include <QImage>
#include <array>
#include <cstdint>

namespace dipwright {

using LinearColour = Eigen::Array3f; // red, green, blue in linear light, 0 … 1

// Converts linear light to an encoded value: the inverse of linearFromSrgb().
double srgbFromLinear(double linear);

// Returns the linear light of every eight-bit value.
const std::array<float, 256>& linearTable();
// Returns the nearest eight-bit value; light outside 0 … 1 is clamped.
std::uint8_t encodedByte(float linear);
// Returns the opaque sRGB pixel of this light.
QRgb encodedPixel(const LinearColour& light);

LinearColour linearColour(const QColor& colour);
// Returns the CIE L*a*b* of light in sRGB's primaries, relative to D65 (CIE 15:2018).
Eigen::Array3f labOf(const LinearColour& light);
// Converts light to wide colour's primaries.
LinearColour wideLight(const LinearColour& srgb);
// Converts light back to sRGB's primaries; colours outside sRGB are clamped.
LinearColour srgbLight(const LinearColour& wide);

// Reads and writes single pixels in the format of `picture`: RGBA8888 or wide RGBA64. Light is in
// the picture's own primaries.
class PixelCode {
public:
    explicit PixelCode(const QImage& picture);

    bool isWide() const { return wide_; }
    std::ptrdiff_t bytes() const { return wide_ ? 8 : 4; } // per pixel
    int opaque() const { return wide_ ? 65535 : 255; }     // the alpha of an opaque pixel
    int alpha(const unsigned char* pixel) const;
    LinearColour light(const unsigned char* pixel) const;
    void write(unsigned char* pixel, const LinearColour& light, int alpha) const;

private:
    bool wide_;
};

} // namespace dipwright
