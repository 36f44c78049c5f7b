// Between the numbers of pictures, eight bits in sRGB or sixteen in wide colour
// (base/WideGamut.h), and linear light, in which pictures are filtered and ink is reckoned.
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QImage>
#include <array>
#include <cstdint>

namespace dipwright {

using LinearColour = Eigen::Array3f; // red, green, blue in linear light, 0 … 1

// IEC 61966-2-1.
double linearFromSrgb(double encoded);
double srgbFromLinear(double linear);

// The linear light of every eight-bit value.
const std::array<float, 256>& linearTable();
// The nearest eight-bit value; out-of-range light is clamped.
std::uint8_t encodedByte(float linear);

LinearColour linearColour(const QColor& colour);
// The same light as shares of wide colour's primaries.
LinearColour wideLight(const LinearColour& srgb);
// And back; what sRGB does not hold at its nearest there.
LinearColour srgbLight(const LinearColour& wide);

// Reads and writes the pixels of pictures like one, RGBA8888 or wide RGBA64; colours are shares of
// its own primaries.
class PixelCode {
public:
    explicit PixelCode(const QImage& picture);

    bool isWide() const { return wide_; }
    std::ptrdiff_t bytes() const { return wide_ ? 8 : 4; } // of a pixel
    int opaque() const { return wide_ ? 65535 : 255; }     // the alpha that hides all behind it
    int alpha(const unsigned char* pixel) const;
    LinearColour light(const unsigned char* pixel) const;
    void write(unsigned char* pixel, const LinearColour& light, int alpha) const;

private:
    bool wide_;
};

} // namespace dipwright
