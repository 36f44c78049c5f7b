// Scales a picture by factors near 1, row by row, for printers whose scales differ across and along
// the page. Private to this folder.
#pragma once

#include <QSize>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace dipwright {

// How the pixels along one side of the result are made: each from four neighbours of the source, by
// cubic convolution (Keys 1981, https://doi.org/10.1109/TASSP.1981.1163711, a = −1/2).
class ScaledSide {
public:
    struct Pixel {
        std::array<int, 4> from; // pixels of the source; the result lies between the middle two
        std::array<float, 4> weight;
    };

    ScaledSide(int from, int to);

    const Pixel& operator[](int pixel) const { return pixels_[std::size_t(pixel)]; }
    int size() const { return int(pixels_.size()); }

private:
    std::vector<Pixel> pixels_;
};

// Rows of a picture with interleaved channels, without padding.
template <typename Sample>
using SampleRows = std::vector<Sample>;

// Returns a value of the result. It stays between the two nearest values of the source, so that no
// edge gets a rim.
inline float scaledValue(const std::array<float, 4>& from, const ScaledSide::Pixel& pixel) {
    float sum = 0;
    for (std::size_t tap = 0; tap < 4; ++tap) {
        sum += from[tap] * pixel.weight[tap];
    }
    return std::clamp(sum, std::min(from[1], from[2]), std::max(from[1], from[2]));
}

// Returns the rows first … end - 1 of the scaled picture. source(first, end) returns rows of the
// original.
template <typename Sample, typename Source>
SampleRows<Sample> scaledRows(const ScaledSide& across, const ScaledSide& down, int channels,
                              int first, int end, const Source& source) {
    const int from = down[first].from.front();
    const int to = down[end - 1].from.back() + 1;
    const SampleRows<Sample> original = source(from, to);
    const std::size_t originalRow = original.size() / std::size_t(to - from);
    const std::size_t row = std::size_t(across.size()) * std::size_t(channels);
    std::vector<float> wide(row * std::size_t(to - from)); // scaled across
    for (std::size_t y = 0; y < std::size_t(to - from); ++y) {
        const Sample* in = original.data() + y * originalRow;
        float* out = wide.data() + y * row;
        for (int x = 0; x < across.size(); ++x) {
            const ScaledSide::Pixel& pixel = across[x];
            for (int channel = 0; channel < channels; ++channel) {
                std::array<float, 4> values;
                for (std::size_t tap = 0; tap < 4; ++tap) {
                    values[tap] = float(in[pixel.from[tap] * channels + channel]);
                }
                *out++ = scaledValue(values, pixel);
            }
        }
    }
    SampleRows<Sample> scaled(row * std::size_t(end - first));
    for (int y = first; y < end; ++y) {
        const ScaledSide::Pixel& pixel = down[y];
        Sample* out = scaled.data() + std::size_t(y - first) * row;
        for (std::size_t i = 0; i < row; ++i) {
            std::array<float, 4> values;
            for (std::size_t tap = 0; tap < 4; ++tap) {
                values[tap] = wide[std::size_t(pixel.from[tap] - from) * row + i];
            }
            out[i] = Sample(std::lround(scaledValue(values, pixel)));
        }
    }
    return scaled;
}

} // namespace dipwright
