#include "texture/LinearLight.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright {

namespace {

// So fine that one step changes the encoded value by less than 0.2, even near black, where the
// curve is steepest.
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

std::vector<float> makeWideTable() {
    std::vector<float> table;
    for (int value = 0; value <= 65535; ++value) {
        table.push_back(float(linearFromSrgb(double(value) / 65535)));
    }
    return table;
}

// Returns the linear light of every sixteen-bit value.
const std::vector<float>& wideTable() {
    static const std::vector<float> table = makeWideTable();
    return table;
}

LinearColour weighted(const LightWeights& weights, const LinearColour& light) {
    LinearColour sum;
    for (int channel = 0; channel < 3; ++channel) {
        const std::array<double, 3>& row = weights[std::size_t(channel)];
        sum[channel] = float(row[0] * double(light[0]) + row[1] * double(light[1]) +
                             row[2] * double(light[2]));
    }
    return sum.max(0.0f).min(1.0f);
}

} // namespace

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

Eigen::Array3f labOf(const LinearColour& light) {
    const auto root = [](float value) {
        return value > 0.008856f ? std::cbrt(value) : 7.787f * value + 16.0f / 116;
    };
    const float x =
        (0.4124564f * light[0] + 0.3575761f * light[1] + 0.1804375f * light[2]) / 0.95047f;
    const float y = 0.2126729f * light[0] + 0.7151522f * light[1] + 0.0721750f * light[2];
    const float z =
        (0.0193339f * light[0] + 0.1191920f * light[1] + 0.9503041f * light[2]) / 1.08883f;
    return {116 * root(y) - 16, 500 * (root(x) - root(y)), 200 * (root(y) - root(z))};
}

QRgb encodedPixel(const LinearColour& light) {
    return qRgb(encodedByte(light[0]), encodedByte(light[1]), encodedByte(light[2]));
}

LinearColour linearColour(const QColor& colour) {
    const std::array<float, 256>& table = linearTable();
    return {table[std::size_t(colour.red())], table[std::size_t(colour.green())],
            table[std::size_t(colour.blue())]};
}

LinearColour wideLight(const LinearColour& srgb) {
    return weighted(srgbToWideLight, srgb);
}

LinearColour srgbLight(const LinearColour& wide) {
    return weighted(wideToSrgbLight, wide);
}

PixelCode::PixelCode(const QImage& picture) : wide_(dipwright::isWide(picture)) {}

int PixelCode::alpha(const unsigned char* pixel) const {
    return wide_ ? int(reinterpret_cast<const std::uint16_t*>(pixel)[3]) : int(pixel[3]);
}

LinearColour PixelCode::light(const unsigned char* pixel) const {
    if (wide_) {
        const auto* numbers = reinterpret_cast<const std::uint16_t*>(pixel);
        const std::vector<float>& table = wideTable();
        return {table[numbers[0]], table[numbers[1]], table[numbers[2]]};
    }
    const std::array<float, 256>& table = linearTable();
    return {table[pixel[0]], table[pixel[1]], table[pixel[2]]};
}

void PixelCode::write(unsigned char* pixel, const LinearColour& light, int alpha) const {
    if (wide_) {
        auto* numbers = reinterpret_cast<std::uint16_t*>(pixel);
        for (int channel = 0; channel < 3; ++channel) {
            const double share = std::clamp(double(light[channel]), 0.0, 1.0);
            numbers[channel] = std::uint16_t(std::lround(65535 * srgbFromLinear(share)));
        }
        numbers[3] = std::uint16_t(alpha);
        return;
    }
    for (int channel = 0; channel < 3; ++channel) {
        pixel[channel] = encodedByte(light[channel]);
    }
    pixel[3] = std::uint8_t(alpha);
}

} // namespace dipwright
