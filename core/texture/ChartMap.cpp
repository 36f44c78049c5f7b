#include "texture/ChartMap.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

constexpr int bandRows = 64; // rows of texels that one thread fills
constexpr double wholeTexture = 0.999;

std::vector<std::uint32_t> trianglesWith(const SurfaceAppearance& appearance, int texture) {
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t triangle = 0; triangle < appearance.textureCoordinates.size(); ++triangle) {
        if (appearance.materials[appearance.material[triangle]].texture == texture &&
            appearance.hasTextureCoordinates(triangle)) {
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

bool isOneChartOnAll(const SurfaceAppearance& appearance,
                     const std::vector<std::uint32_t>& triangles) {
    double area = 0;
    for (const std::uint32_t triangle : triangles) {
        if (appearance.chart[triangle] != appearance.chart[triangles.front()]) {
            return false;
        }
        const auto& [a, b, c] = appearance.textureCoordinates[triangle];
        area += std::abs(double((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x())) / 2;
    }
    return area > wholeTexture;
}

// Returns the x interval of the line y = `row` that lies inside a triangle, from left to right.
std::pair<double, double> crossing(const std::array<Eigen::Vector2d, 3>& corners, double row) {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::pair<double, double> part{far, -far};
    for (std::size_t edge = 0; edge < 3; ++edge) {
        Eigen::Vector2d upper = corners[edge];
        Eigen::Vector2d lower = corners[(edge + 1) % 3];
        if (upper.y() > lower.y()) {
            std::swap(upper, lower);
        }
        if (row < upper.y() || row > lower.y() || upper.y() == lower.y()) {
            continue;
        }
        const double share = (row - upper.y()) / (lower.y() - upper.y());
        const double place = upper.x() + share * (lower.x() - upper.x());
        part = {std::min(part.first, place), std::max(part.second, place)};
    }
    return part;
}

} // namespace

bool textureRepeats(const SurfaceAppearance& appearance, int texture) {
    constexpr float rounding = 1e-4f;
    const std::vector<std::uint32_t> triangles = trianglesWith(appearance, texture);
    return std::any_of(triangles.begin(), triangles.end(), [&](std::uint32_t triangle) {
        const auto& corners = appearance.textureCoordinates[triangle];
        return std::any_of(corners.begin(), corners.end(), [](const Eigen::Vector2f& corner) {
            return corner.minCoeff() < -rounding || corner.maxCoeff() > 1 + rounding;
        });
    });
}

std::unique_ptr<ChartMap> ChartMap::of(const SurfaceAppearance& appearance, int texture) {
    const std::vector<std::uint32_t> triangles = trianglesWith(appearance, texture);
    if (triangles.empty() || isOneChartOnAll(appearance, triangles)) {
        return nullptr;
    }
    return std::unique_ptr<ChartMap>(new ChartMap(appearance, texture));
}

ChartMap::ChartMap(const SurfaceAppearance& appearance, int texture)
    : width_(appearance.textures[std::size_t(texture)].width()),
      height_(appearance.textures[std::size_t(texture)].height()),
      owner_(std::size_t(width_) * std::size_t(height_), nobody) {
    const int bands = (height_ + bandRows - 1) / bandRows;
    std::vector<std::vector<std::uint32_t>> inBand(static_cast<std::size_t>(bands));
    for (const std::uint32_t triangle : trianglesWith(appearance, texture)) {
        const auto& [a, b, c] = appearance.textureCoordinates[triangle];
        const auto band = [&](float v) {
            return std::clamp(int((1 - v) * float(height_)) / bandRows, 0, bands - 1);
        };
        const int last = band(std::min({a.y(), b.y(), c.y()}));
        for (int at = band(std::max({a.y(), b.y(), c.y()})); at <= last; ++at) {
            inBand[std::size_t(at)].push_back(triangle);
        }
    }
    parallelFor(0, bands, [&](int band) {
        fillRows(appearance, inBand[std::size_t(band)], band * bandRows,
                 std::min(height_, (band + 1) * bandRows));
    });
    findBlocks();
}

void ChartMap::fillRows(const SurfaceAppearance& appearance,
                        const std::vector<std::uint32_t>& triangles, int begin, int end) {
    for (const std::uint32_t triangle : triangles) {
        std::array<Eigen::Vector2d, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2f& place = appearance.textureCoordinates[triangle][corner];
            corners[corner] = {double(place.x()) * width_, (1 - double(place.y())) * height_};
        }
        const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
        const int last = std::min(end - 1, int(std::floor(bottom - 0.5)));
        for (int row = std::max(begin, int(std::ceil(top - 0.5))); row <= last; ++row) {
            const auto [left, right] = crossing(corners, row + 0.5);
            if (left > right) {
                continue;
            }
            const int lastColumn = std::min(width_ - 1, int(std::floor(right - 0.5)));
            for (int column = std::max(0, int(std::ceil(left - 0.5))); column <= lastColumn;
                 ++column) {
                std::uint32_t& owner =
                    owner_[std::size_t(row) * std::size_t(width_) + std::size_t(column)];
                owner = owner == nobody || owner == appearance.chart[triangle]
                            ? appearance.chart[triangle]
                            : several;
            }
        }
    }
}

void ChartMap::findBlocks() {
    blockColumns_ = (width_ + blockSize - 1) / blockSize;
    const int blockRows = (height_ + blockSize - 1) / blockSize;
    block_.resize(std::size_t(blockColumns_) * std::size_t(blockRows));
    parallelFor(0, blockRows, [&](int blockRow) {
        for (int blockColumn = 0; blockColumn < blockColumns_; ++blockColumn) {
            const auto texel = [&](int row, int column) {
                return owner_[std::size_t(row) * std::size_t(width_) + std::size_t(column)];
            };
            const int firstRow = blockRow * blockSize;
            const int firstColumn = blockColumn * blockSize;
            std::uint32_t owner = texel(firstRow, firstColumn);
            for (int row = firstRow; row < std::min(height_, firstRow + blockSize); ++row) {
                for (int column = firstColumn; column < std::min(width_, firstColumn + blockSize);
                     ++column) {
                    owner = texel(row, column) == owner ? owner : nobody;
                }
            }
            block_[std::size_t(blockRow) * std::size_t(blockColumns_) + std::size_t(blockColumn)] =
                owner;
        }
    });
}

bool ChartMap::isWithin(const Eigen::AlignedBox2f& box, std::uint32_t chart) const {
    const auto block = [](float place, int length) {
        return int(std::clamp(place, 0.0f, float(length - 1))) / blockSize;
    };
    const int right = block(box.max().x(), width_);
    const int bottom = block(box.max().y(), height_);
    for (int row = block(box.min().y(), height_); row <= bottom; ++row) {
        for (int column = block(box.min().x(), width_); column <= right; ++column) {
            const std::uint32_t owner =
                block_[std::size_t(row) * std::size_t(blockColumns_) + std::size_t(column)];
            if (owner != chart && owner != several) {
                return false;
            }
        }
    }
    return true;
}

} // namespace dipwright
