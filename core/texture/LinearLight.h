// Between sRGB's eight bits and linear light, in which pictures are filtered and ink is reckoned.
#pragma once

#include <Eigen/Core>
#include <QColor>
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

} // namespace dipwright
