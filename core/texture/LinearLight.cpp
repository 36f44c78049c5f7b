#include "texture/LinearLight.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Fine enough that the steps near black, where the curve is steepest, stay under a fifth of a
// value.
constexpr int encodingSteps = 1 << 14;

std::array<float, 256> makeLinearTable() {
    std::array<float, 256> table{};
    for (std::size_t value = 0; value < table.size(); ++value) {
        table[value] = float(linearFromSrgb(double(value) / 255));
    }
    return table;
}

std::array<std::uint8_t, encodingSteps + 1> makeEncodingTable() {
    std::array<std::uint8_t, encodingSteps + 1> table{};
    for (std::size_t step = 0; step < table.size(); ++step) {
        table[step] = std::uint8_t(std::lround(255 * srgbFromLinear(double(step) / encodingSteps)));
    }
    return table;
}

} // namespace

double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

const std::array<float, 256>& linearTable() {
    static const std::array<float, 256> table = makeLinearTable();
    return table;
}

std::uint8_t encodedByte(float linear) {
    static const std::array<std::uint8_t, encodingSteps + 1> table = makeEncodingTable();
    return table[std::size_t(std::lrint(std::clamp(linear, 0.0f, 1.0f) * encodingSteps))];
}

LinearColour linearColour(const QColor& colour) {
    const std::array<float, 256>& table = linearTable();
    return {table[std::size_t(colour.red())], table[std::size_t(colour.green())],
            table[std::size_t(colour.blue())]};
}

} // namespace dipwright
