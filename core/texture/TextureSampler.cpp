#include "texture/TextureSampler.h"

#include "base/WideGamut.h"

#include "parallel/ParallelFor.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr int mostTaps = 16;  // along the longer axis
constexpr int mostPlaces = 8; // along each axis, near a chart's border
constexpr float fullLight = 65535;

using LightTexel = std::array<std::uint16_t, 4>;

LightTexel lightTexel(const LinearColour& light) {
    LightTexel texel{};
    for (int channel = 0; channel < 3; ++channel) {
        texel[std::size_t(channel)] =
            std::uint16_t(std::lrint(std::min(light[channel], 1.0f) * fullLight));
    }
    return texel;
}

// Returns the texels of a picture in wide colour, laid over white.
std::vector<LightTexel> lightTexels(const QImage& wide) {
    const PixelCode code(wide);
    const auto columns = std::size_t(wide.width());
    std::vector<LightTexel> texels(columns * std::size_t(wide.height()));
    parallelFor(0, wide.height(), [&](int row) {
        const uchar* pixel = wide.constScanLine(row);
        for (std::size_t column = 0; column < columns; ++column, pixel += code.bytes()) {
            const float opacity = float(code.alpha(pixel)) / float(code.opaque());
            texels[std::size_t(row) * columns + column] =
                lightTexel(opacity * code.light(pixel) + 1 - opacity);
        }
    });
    return texels;
}

bool isOpaque(const QImage& image) {
    for (int row = 0; row < image.height(); ++row) {
        const auto* texel = image.constScanLine(row);
        for (int column = 0; column < image.width(); ++column) {
            if (texel[4 * column + 3] != 255) {
                return false;
            }
        }
    }
    return true;
}

// Returns the picture on white, with rows that follow each other without gaps. Returns wide
// pictures unchanged, because their colours are read from the first level instead.
QImage onWhite(const QImage& image) {
    const bool gapless = image.bytesPerLine() == 4 * qsizetype(image.width());
    if (isWide(image) || (isOpaque(image) && gapless)) {
        return image;
    }
    QImage opaque = image.copy();
    const std::array<float, 256>& linear = linearTable();
    for (int row = 0; row < opaque.height(); ++row) {
        auto* texel = opaque.scanLine(row);
        for (int column = 0; column < opaque.width(); ++column, texel += 4) {
            const float opacity = float(texel[3]) / 255;
            for (int channel = 0; channel < 3; ++channel) {
                texel[channel] = encodedByte(opacity * linear[texel[channel]] + 1 - opacity);
            }
            texel[3] = 255;
        }
    }
    return opaque;
}

// The range of pixels that one pixel of a halved row or column covers.
struct Cover {
    int first = 0;
    int count = 0; // two, or three if the length is odd
    std::array<float, 3> weights{};
};
std::vector<Cover> halvingCovers(int length) {
    const int half = (length + 1) / 2;
    const double ratio = double(length) / half;
    std::vector<Cover> covers(static_cast<std::size_t>(half));
    for (int pixel = 0; pixel < half; ++pixel) {
        const double begin = pixel * ratio;
        const double end = begin + ratio;
        Cover& cover = covers[std::size_t(pixel)];
        cover.first = int(begin);
        cover.count = std::min(int(std::ceil(end)), length) - cover.first;
        for (int part = 0; part < cover.count; ++part) {
            const double from = std::max(begin, double(cover.first + part));
            const double to = std::min(end, double(cover.first + part + 1));
            cover.weights[std::size_t(part)] = float((to - from) / ratio);
        }
    }
    return covers;
}

// Places along one axis of a pixel, in texels of the first level.
struct Taps {
    int count = 1;
    float step = 0;
};
// Returns the taps over a pixel's `length`. `spot` is its shorter side, and `texel` is the size of
// the level's texels; all in texels of the first level. On a square of two texels or more, the two
// taps of each axis lie 0.4 of its side apart. On a smaller square they lie closer, so that the
// variance of taps and linear interpolation (texel²/6) together stays in proportion to its area.
Taps tapsOver(float length, float spot, float texel) {
    constexpr float widest = 0.8F; // twice the distance of two taps, in sides
    constexpr float variance = widest * widest / 16 + 1.0F / 24;
    const float ratio = texel / spot;
    const float width =
        4 * std::sqrt(std::max(std::min(variance - ratio * ratio / 6, widest * widest / 16), 0.0F));
    const float taken = length - (1 - width) * spot;
    if (!(taken > 0)) {
        return {};
    }
    const int count = std::max(int(std::ceil(length / texel - 1e-3F)), 1);
    return {count, taken / float(count)};
}

// Returns the share of cubic interpolation for a pixel with these sides in texels. Linear
// interpolation blurs most where texels and pixels have the same size. Coarse textures stay linear,
// because cubic interpolation would show rims at their edges.
float cubicShare(float longer, float shorter) {
    constexpr float coarse = 0.5F, fine = 1.386F;
    return std::clamp(std::min((shorter - coarse) / (1 - coarse), (fine - longer) / (fine - 1)),
                      0.0F, 1.0F);
}

// Returns the weights of four texels, for a place `x` after the second (Keys 1981, a = −½).
std::array<float, 4> cubicWeights(float x) {
    return {((-0.5F * x + 1) * x - 0.5F) * x, (1.5F * x - 2.5F) * x * x + 1,
            ((-1.5F * x + 2) * x + 0.5F) * x, (0.5F * x - 0.5F) * x * x};
}

} // namespace

TextureSampler::TextureSampler(const QImage& image, bool repeats)
    : image_(onWhite(image)), encoded_(image_.constBits()), linear_(linearTable()),
      repeats_(repeats) {
    levels_.push_back({image.width(), image.height(),
                       isWide(image) ? lightTexels(image) : std::vector<LightTexel>()});
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        levels_.push_back(halved(levels_.back()));
    }
}

LinearColour TextureSampler::texel(const Level& level, std::size_t index) const {
    if (level.texels.empty()) {
        const auto* encoded = encoded_ + 4 * index;
        return {linear_[encoded[0]], linear_[encoded[1]], linear_[encoded[2]]};
    }
    const std::array<std::uint16_t, 4>& light = level.texels[index];
    return LinearColour(light[0], light[1], light[2]) / fullLight;
}

TextureSampler::Level TextureSampler::halved(const Level& level) const {
    const std::vector<Cover> columns = halvingCovers(level.width);
    const std::vector<Cover> rows = halvingCovers(level.height);
    Level half{int(columns.size()), int(rows.size()), {}};
    half.texels.resize(columns.size() * rows.size());
    parallelFor(std::size_t(0), rows.size(), [&](std::size_t row) {
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const Cover& across = columns[column];
            LinearColour sum = LinearColour::Zero();
            for (int down = 0; down < rows[row].count; ++down) {
                const std::size_t first =
                    std::size_t(rows[row].first + down) * std::size_t(level.width) +
                    std::size_t(across.first);
                LinearColour line = LinearColour::Zero();
                for (int right = 0; right < across.count; ++right) {
                    line += across.weights[std::size_t(right)] *
                            texel(level, first + std::size_t(right));
                }
                sum += rows[row].weights[std::size_t(down)] * line;
            }
            half.texels[row * columns.size() + column] = lightTexel(sum);
        }
    });
    return half;
}

Eigen::Vector2f TextureSampler::size() const {
    return {float(image_.width()), float(image_.height())};
}

TextureFootprint TextureSampler::footprint(const TextureSteps& steps) const {
    const Eigen::Matrix2f texels = size().asDiagonal() * steps;
    if (!texels.allFinite()) {
        return {};
    }
    const Eigen::JacobiSVD<Eigen::Matrix2f> axes(texels, Eigen::ComputeFullU);
    const float longer = axes.singularValues()[0];
    const float shorter = axes.singularValues()[1];
    TextureFootprint footprint;
    footprint.cubic = cubicShare(longer, shorter);
    const float spot = std::max(shorter, longer / float(mostTaps / 2)); // texels
    const float texel = std::max(spot / 2, 1.0f);                       // of the level
    footprint.level = std::clamp(std::log2(texel), 0.0f, float(levels_.size() - 1));
    const Taps along = tapsOver(longer, spot, texel);
    const Taps across = tapsOver(spot, spot, texel);
    const auto step = [&](int axis, const Taps& taps) -> Eigen::Vector2f {
        return (axes.matrixU().col(axis) * taps.step).cwiseQuotient(size());
    };
    footprint.along = along.count;
    footprint.alongStep = step(0, along);
    footprint.across = across.count;
    footprint.acrossStep = step(1, across);
    return footprint;
}

Eigen::Vector2f TextureSampler::onLevel(const Level& level,
                                        const Eigen::Vector2f& coordinate) const {
    float u = coordinate.x();
    float v = 1 - coordinate.y();
    if (repeats_) {
        u -= std::floor(u);
        v -= std::floor(v);
    } else {
        u = std::clamp(u, 0.0f, 1.0f);
        v = std::clamp(v, 0.0f, 1.0f);
    }
    return {u * float(level.width) - 0.5f, v * float(level.height) - 0.5f};
}

std::size_t TextureSampler::inside(int index, int length) const {
    if (repeats_) {
        return std::size_t((index % length + length) % length);
    }
    return std::size_t(std::clamp(index, 0, length - 1));
}

TextureSampler::Corners TextureSampler::corners(const Level& level,
                                                const Eigen::Vector2f& coordinate) const {
    const Eigen::Vector2f place = onLevel(level, coordinate);
    const float x = place.x();
    const float y = place.y();
    const float left = std::floor(x);
    const float top = std::floor(y);
    const std::size_t x0 = inside(int(left), level.width);
    const std::size_t x1 = inside(int(left) + 1, level.width);
    const std::size_t y0 = inside(int(top), level.height) * std::size_t(level.width);
    const std::size_t y1 = inside(int(top) + 1, level.height) * std::size_t(level.width);
    const float right = x - left;
    const float down = y - top;
    return {{y0 + x0, y0 + x1, y1 + x0, y1 + x1},
            {(1 - right) * (1 - down), right * (1 - down), (1 - right) * down, right * down}};
}

LinearColour TextureSampler::bilinear(const Level& level, const Eigen::Vector2f& coordinate) const {
    const Corners around = corners(level, coordinate);
    LinearColour sum = LinearColour::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner) {
        sum += around.weight[corner] * texel(level, around.texel[corner]);
    }
    return sum;
}

LinearColour TextureSampler::trilinear(const Eigen::Vector2f& coordinate, float level) const {
    const auto finer = std::size_t(level);
    const float between = level - float(finer);
    LinearColour colour = bilinear(levels_[finer], coordinate);
    if (between == 0) {
        return colour;
    }
    return (1 - between) * colour + between * bilinear(levels_[finer + 1], coordinate);
}

LinearColour TextureSampler::cubic(const Eigen::Vector2f& coordinate) const {
    const Level& level = levels_[0];
    const Eigen::Vector2f place = onLevel(level, coordinate);
    const int left = int(std::floor(place.x()));
    const int top = int(std::floor(place.y()));
    const std::array<float, 4> across = cubicWeights(place.x() - float(left));
    const std::array<float, 4> down = cubicWeights(place.y() - float(top));
    LinearColour sum = LinearColour::Zero();
    for (int row = 0; row < 4; ++row) {
        const std::size_t first = inside(top - 1 + row, level.height) * std::size_t(level.width);
        LinearColour line = LinearColour::Zero();
        for (int column = 0; column < 4; ++column) {
            line += across[std::size_t(column)] *
                    texel(level, first + inside(left - 1 + column, level.width));
        }
        sum += down[std::size_t(row)] * line;
    }
    return sum.max(0.0f).min(1.0f);
}

LinearColour TextureSampler::sample(const Eigen::Vector2f& coordinate,
                                    const TextureFootprint& footprint) const {
    if (footprint.cubic > 0) {
        return footprint.cubic * cubic(coordinate) +
               (1 - footprint.cubic) * bilinear(levels_[0], coordinate);
    }
    LinearColour sum = LinearColour::Zero();
    for (int tap = 0; tap < footprint.along; ++tap) {
        const Eigen::Vector2f line =
            coordinate + (float(tap) - float(footprint.along - 1) / 2) * footprint.alongStep;
        for (int side = 0; side < footprint.across; ++side) {
            const float offset = float(side) - float(footprint.across - 1) / 2;
            sum += trilinear(line + offset * footprint.acrossStep, footprint.level);
        }
    }
    return sum / float(footprint.along * footprint.across);
}

LinearColour TextureSampler::sampleWithin(const Eigen::Vector2f& coordinate,
                                          const TextureSteps& steps, const ChartMap& charts,
                                          std::uint32_t chart) const {
    const float texels = longestStep(steps);
    const int places = int(std::clamp(std::ceil(texels), 1.0f, float(mostPlaces)));
    LinearColour sum = LinearColour::Zero();
    float weights = 0;
    for (int row = 0; row < places; ++row) {
        for (int column = 0; column < places; ++column) {
            const Eigen::Vector2f inPixel((float(column) + 0.5f) / float(places) - 0.5f,
                                          (float(row) + 0.5f) / float(places) - 0.5f);
            const Corners around = corners(levels_[0], coordinate + steps * inPixel);
            for (std::size_t corner = 0; corner < 4; ++corner) {
                if (charts.belongs(around.texel[corner], chart)) {
                    sum += around.weight[corner] * texel(levels_[0], around.texel[corner]);
                    weights += around.weight[corner];
                }
            }
        }
    }
    // If no texel here belongs to the chart, the chart is thinner than a texel, and all texels are
    // used.
    return weights > 0 ? LinearColour(sum / weights) : bilinear(levels_[0], coordinate);
}

bool TextureSampler::isWithin(const std::array<Eigen::Vector2f, 3>& corners,
                              const TextureSteps& steps, const ChartMap& charts,
                              std::uint32_t chart) const {
    // Half the pixel, plus the neighbouring texels that interpolation reads on the coarser level.
    const float margin = 2 + 2.5f * longestStep(steps);
    Eigen::AlignedBox2f box;
    for (const Eigen::Vector2f& corner : corners) {
        box.extend(Eigen::Vector2f(corner.x(), 1 - corner.y()).cwiseProduct(size()));
    }
    box.extend(Eigen::Vector2f(box.min().array() - margin));
    box.extend(Eigen::Vector2f(box.max().array() + margin));
    return charts.isWithin(box, chart);
}

float TextureSampler::longestStep(const TextureSteps& steps) const {
    return (size().asDiagonal() * steps).colwise().norm().maxCoeff();
}

} // namespace dipwright
