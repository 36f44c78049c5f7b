#include "Painting.h"

#include <QFont>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace dipwright::samples {

namespace {

constexpr int oversampling = 2;
constexpr int overhangPixels = 8;

double cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    return double(a.x()) * b.y() - double(a.y()) * b.x();
}

// Calls `paint(x, y, weights)` for each pixel whose centre is in the triangle. `weights` holds the
// centre's barycentric coordinates.
template <typename Paint>
void rasterise(const std::array<Eigen::Vector2f, 3>& corners, const Paint& paint) {
    const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
    const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    for (int y = int(std::floor(top)); y <= int(bottom); ++y) {
        for (int x = int(std::floor(left)); x <= int(right); ++x) {
            const Eigen::Vector2f pixel(float(x) + 0.5F, float(y) + 0.5F);
            Eigen::Vector3f weights;
            for (int i = 0; i < 3; ++i) {
                weights[i] =
                    float(cross(corners[(i + 1) % 3] - pixel, corners[(i + 2) % 3] - pixel) / area);
            }
            if (weights.minCoeff() >= 0) {
                paint(x, y, weights);
            }
        }
    }
}

// Extends the painted pixels outwards by one pixel.
void growByOne(QImage& image) {
    const QImage before = image.copy();
    const auto painted = [&](int x, int y) {
        return before.valid(x, y) && qAlpha(before.pixel(x, y)) > 0;
    };
    for (int y = 0; y < image.height(); ++y) {
        const auto* line = reinterpret_cast<const QRgb*>(before.constScanLine(y));
        auto* target = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            if (qAlpha(line[x]) > 0) {
                continue;
            }
            for (const auto& [nextX, nextY] : {std::pair(x - 1, y), std::pair(x + 1, y),
                                               std::pair(x, y - 1), std::pair(x, y + 1)}) {
                if (painted(nextX, nextY)) {
                    target[x] = before.pixel(nextX, nextY);
                    break;
                }
            }
        }
    }
}

} // namespace

TexturedMesh textured(TriangleMesh mesh, std::vector<std::array<Eigen::Vector2f, 3>> coordinates,
                      QImage texture) {
    TexturedMesh model;
    model.material.assign(mesh.triangles.size(), 0);
    model.mesh = std::move(mesh);
    model.textureCoordinates = std::move(coordinates);
    model.materials = {{QStringLiteral("paint"), QColor(Qt::white), 0}};
    model.textures = {texture.convertToFormat(QImage::Format_RGBA8888)};
    model.chart = findCharts(model);
    return model;
}

void paintLetters(QPainter& painter, QPointF centre, double height, const QString& text,
                  double widening) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setBold(true);
    font.setPixelSize(100);
    QPainterPath letters;
    letters.addText(0, 0, font, text);
    const QRectF box = letters.boundingRect();
    // 73: height of a capital letter at a font size of 100 pixels.
    const double scale = height / 73;
    QTransform place;
    place.translate(centre.x(), centre.y());
    place.scale(scale * widening, scale);
    place.translate(-box.center().x(), 36.5);
    painter.drawPath(place.map(letters));
}

QImage bakeTexture(const TriangleMesh& mesh,
                   const std::vector<std::array<Eigen::Vector2f, 3>>& coordinates,
                   const std::vector<Eigen::Vector3f>& places,
                   const std::function<QRgb(const Eigen::Vector3f&)>& colour) {
    const int side = oversampling * texturePixels;
    QImage image(side, side, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<Eigen::Vector2f, 3> pixels;
        for (int corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2f& uv = coordinates[t][corner];
            pixels[corner] = float(side) * Eigen::Vector2f(uv.x(), 1 - uv.y());
        }
        rasterise(pixels, [&](int x, int y, const Eigen::Vector3f& weights) {
            Eigen::Vector3f place = Eigen::Vector3f::Zero();
            for (int corner = 0; corner < 3; ++corner) {
                place += weights[corner] * places[mesh.triangles[t][corner]];
            }
            image.setPixel(x, y, colour(place));
        });
    }
    for (int i = 0; i < oversampling * overhangPixels; ++i) {
        growByOne(image);
    }
    return image.scaled(texturePixels, texturePixels, Qt::IgnoreAspectRatio,
                        Qt::SmoothTransformation);
}

} // namespace dipwright::samples
