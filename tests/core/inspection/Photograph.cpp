#include "Photograph.h"

#include "parallel/ParallelFor.h"

#include <QBuffer>
#include <algorithm>
#include <cmath>
#include <random>

namespace dipwright::test {

namespace {

using Plane = std::vector<float>;

// Blurs in one direction by a Gaussian. The values of the picture's last pixels continue past its
// edge.
Plane blurred(const Plane& plane, int width, int height, double sigma, bool across) {
    const int reach = int(std::ceil(4 * sigma));
    std::vector<double> weights;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-i * i / (2 * sigma * sigma)));
        sum += weights.back();
    }
    Plane result(plane.size());
    parallelFor(0, height, [&](int y) {
        const auto row = [&](int number) {
            return plane.begin() + std::ptrdiff_t(std::clamp(number, 0, height - 1)) * width;
        };
        std::vector<float> wide(std::size_t(width + 2 * reach), *row(y));
        std::copy_n(row(y), width, wide.begin() + reach);
        std::fill_n(wide.end() - reach, reach, *(row(y) + width - 1));
        std::vector<double> values(std::size_t(width), 0);
        for (int i = -reach; i <= reach; ++i) {
            const double weight = weights[std::size_t(i + reach)] / sum;
            const float* const from = across ? &wide[std::size_t(i + reach)] : &*row(y + i);
            for (std::size_t x = 0; x < values.size(); ++x) {
                values[x] += weight * double(from[x]);
            }
        }
        std::copy(values.begin(), values.end(), result.begin() + std::ptrdiff_t(y) * width);
    });
    return result;
}

void shine(Plane& plane, int width, int height, const PhotoLight& light) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            float& level = plane[std::size_t(y) * std::size_t(width) + std::size_t(x)];
            level *= float(1 - light.uneven * (1 - double(x) / width));
            if (light.glare) {
                const double away = std::hypot(x - 0.55 * width, y - 0.45 * height) / width;
                level += float(1.5 * std::exp(-away * away / 0.003));
            }
        }
    }
}

QImage throughJpeg(const QImage& picture, int quality) {
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    picture.save(&buffer, "JPEG", quality);
    return QImage::fromData(buffer.data(), "JPEG");
}

QImage developed(Plane plane, QSize size, const PhotoLight& light) {
    const int width = size.width(), height = size.height();
    shine(plane, width, height, light);
    plane = blurred(plane, width, height, light.blur, true);
    plane = blurred(plane, width, height, light.blur, false);
    std::mt19937 random(light.seed);
    std::normal_distribution<double> noise(0, 1);
    QImage picture(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < width; ++x) {
            const double level = std::clamp(
                double(plane[std::size_t(y) * std::size_t(width) + std::size_t(x)]), 0.0, 1.0);
            const double grey = 255 * std::pow(level, 1 / 2.2) + light.noise * noise(random);
            const int byte = std::clamp(int(std::lround(grey)), 0, 255);
            line[x] = qRgb(byte, byte, byte);
        }
    }
    return light.jpegQuality > 0 ? throughJpeg(picture, light.jpegQuality) : picture;
}

} // namespace

Eigen::Vector2d PhotoLens::pixelOf(const Eigen::Vector3d& place) const {
    const Eigen::Vector2d plain = focalLength * place.head<2>() / place.z();
    const double r2 = plain.squaredNorm();
    const Eigen::Vector2d middle(size.width() / 2.0, size.height() / 2.0);
    return middle + middle.norm() * plain * (1 + k1 * r2 + k2 * r2 * r2);
}

Eigen::Vector3d PhotoLens::sight(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d middle(size.width() / 2.0, size.height() / 2.0);
    const Eigen::Vector2d target = (pixel - middle) / middle.norm();
    Eigen::Vector2d plain = target;
    for (int round = 0; round < 12; ++round) {
        const double r2 = plain.squaredNorm();
        plain = target / (1 + k1 * r2 + k2 * r2 * r2);
    }
    return {plain.x() / focalLength, plain.y() / focalLength, 1};
}

namespace {

// Holds the light at the corners of all pixels: one row and one column more than the photo has
// pixels.
class Corners {
public:
    Corners(const PhotoLens& lens, const LightFrom& lightFrom)
        : columns_(lens.size.width() + 1), rows_(lens.size.height() + 1),
          light_(std::size_t(columns_) * std::size_t(rows_)) {
        parallelFor(0, rows_, [&](int y) {
            for (int x = 0; x < columns_; ++x) {
                light_[index(x, y)] = float(lightFrom(lens.sight(Eigen::Vector2d(x, y))));
            }
        });
    }

    double mean(int x, int y) const {
        return (double(light_[index(x, y)]) + double(light_[index(x + 1, y)]) +
                double(light_[index(x, y + 1)]) + double(light_[index(x + 1, y + 1)])) /
               4;
    }
    // Tells whether the light is even in the pixel and the pixels around it.
    bool isEven(int x, int y) const {
        constexpr float most = 0.008F; // two of 255 levels
        float least = 1, largest = 0;
        for (int row = std::max(y - 1, 0); row <= std::min(y + 2, rows_ - 1); ++row) {
            for (int column = std::max(x - 1, 0); column <= std::min(x + 2, columns_ - 1);
                 ++column) {
                least = std::min(least, light_[index(column, row)]);
                largest = std::max(largest, light_[index(column, row)]);
            }
        }
        return largest - least < most;
    }

private:
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(columns_) + std::size_t(x);
    }

    int columns_, rows_;
    Plane light_;
};

} // namespace

QImage photograph(const PhotoLens& lens, int samples, const LightFrom& lightFrom,
                  const PhotoLight& light) {
    const int width = lens.size.width(), height = lens.size.height();
    const Corners corners(lens, lightFrom);
    Plane plane(std::size_t(width) * std::size_t(height));
    parallelFor(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            float& level = plane[std::size_t(y) * std::size_t(width) + std::size_t(x)];
            if (corners.isEven(x, y)) {
                level = float(corners.mean(x, y));
                continue;
            }
            // Within a pixel the lens is linear.
            const Eigen::Vector3d corner = lens.sight(Eigen::Vector2d(x, y));
            const Eigen::Vector3d right = lens.sight(Eigen::Vector2d(x + 1, y)) - corner;
            const Eigen::Vector3d down = lens.sight(Eigen::Vector2d(x, y + 1)) - corner;
            double sum = 0;
            for (int i = 0; i < samples * samples; ++i) {
                const double u = (i % samples + 0.5) / samples, v = (i / samples + 0.5) / samples;
                sum += lightFrom(corner + u * right + v * down);
            }
            level = float(sum / (samples * samples));
        }
    });
    return developed(std::move(plane), lens.size, light);
}

} // namespace dipwright::test
