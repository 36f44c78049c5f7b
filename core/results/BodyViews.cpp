#include "results/BodyViews.h"

#include "parallel/ParallelFor.h"
#include "results/AdaptiveSampling.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Results)
};

constexpr int samplesAcross = 3;      // samples per pixel in each direction; odd
constexpr float marginFactor = 1.22f; // span of the view divided by the body's own span

// One view: the light in each pixel.
class View {
public:
    View(const SeenBody& body, const RayLight& light, const BodyCamera& camera, float span,
         QSize size)
        : body_(body), light_(light), camera_(camera), span_(span), size_(size),
          centres_(std::size_t(size.width()) * std::size_t(size.height())),
          shown_(centres_.size()) {
        parallelFor(0, size.height(), [&](int y) {
            for (int x = 0; x < size.width(); ++x) {
                const std::size_t at = index(x, y);
                centres_[at] = sample(samplesAcross * x + samplesAcross / 2,
                                      samplesAcross * y + samplesAcross / 2);
                shown_[at] = encoded(centres_[at]);
            }
        });
    }

    PixelBytes pixel(int x, int y) const {
        return isEven(shown_, size_, x, y) ? shown_[index(x, y)] : encoded(meanLight(x, y));
    }

private:
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(size_.width()) + std::size_t(x);
    }

    static PixelBytes encoded(const LinearColour& light) {
        return {encodedByte(light[0]), encodedByte(light[1]), encodedByte(light[2])};
    }

    LinearColour sample(int column, int row) const {
        const QPointF pixel((column + 0.5) / samplesAcross, (row + 0.5) / samplesAcross);
        return light_(camera_.ray(pixel, span_, size_), body_.at(column, row))
            .min(1.0f); // before averaging, so that edges of highlights stay smooth
    }

    LinearColour meanLight(int x, int y) const {
        LinearColour sum = LinearColour::Zero();
        for (int j = 0; j < samplesAcross; ++j) {
            for (int i = 0; i < samplesAcross; ++i) {
                const bool isCentre = 2 * i + 1 == samplesAcross && 2 * j + 1 == samplesAcross;
                sum += isCentre ? centres_[index(x, y)]
                                : sample(samplesAcross * x + i, samplesAcross * y + j);
            }
        }
        return sum / float(samplesAcross * samplesAcross);
    }

    const SeenBody& body_;
    const RayLight& light_;
    const BodyCamera& camera_;
    float span_;
    QSize size_;
    std::vector<LinearColour> centres_; // light at the pixels' centres
    std::vector<PixelBytes> shown_;     // the same, encoded
};

} // namespace

BodyCamera::BodyCamera(const BoundingBox& box, float turn, float elevation)
    : middle_(box.center()), back_(std::sin(turn) * std::cos(elevation), std::sin(elevation),
                                   std::cos(turn) * std::cos(elevation)),
      right_(std::cos(turn), 0, -std::sin(turn)), up_(back_.cross(right_)),
      distance_(3.2f * box.diagonal().norm()) {}

float BodyCamera::span(const TriangleMesh& mesh, QSize tile) const {
    const float aspect = float(tile.width()) / float(tile.height());
    float span = 0;
    for (const Eigen::Vector3f& position : mesh.positions) {
        const Eigen::Vector3f offset = position - middle_;
        const float depth = distance_ - offset.dot(back_);
        span = std::max({span, std::abs(offset.dot(right_)) / depth / aspect,
                         std::abs(offset.dot(up_)) / depth});
    }
    return span;
}

BodyRay BodyCamera::ray(QPointF pixel, float span, QSize tile) const {
    const float aspect = float(tile.width()) / float(tile.height());
    const float x = 2 * (float(pixel.x()) / float(tile.width())) - 1;
    const float y = 1 - 2 * (float(pixel.y()) / float(tile.height()));
    return {middle_ + distance_ * back_,
            (-back_ + span * (x * aspect * right_ + y * up_)).normalized()};
}

SeenBody BodyCamera::see(const TriangleMesh& mesh, float span, QSize tile) const {
    const QSize samples = samplesAcross * tile;
    const double across = double(span) * tile.width() / tile.height();
    std::vector<ViewedPoint> points(mesh.positions.size());
    parallelFor(std::size_t(0), points.size(), [&](std::size_t position) {
        const Eigen::Vector3d offset = (mesh.positions[position] - middle_).cast<double>();
        const double nearness = 1 / (double(distance_) - offset.dot(back_.cast<double>()));
        const double x = offset.dot(right_.cast<double>()) * nearness / across;
        const double y = offset.dot(up_.cast<double>()) * nearness / double(span);
        points[position] = {(x + 1) / 2 * samples.width(), (1 - y) / 2 * samples.height(), nearness,
                            nearness};
    });
    return {mesh, std::move(points), samples};
}

std::vector<BodyCamera> sixSides(const BoundingBox& box, float elevation) {
    constexpr float straight = std::numbers::pi_v<float> / 2;
    return {BodyCamera(box, 0, elevation),
            BodyCamera(box, straight, elevation),
            BodyCamera(box, 0, straight),
            BodyCamera(box, 2 * straight, elevation),
            BodyCamera(box, 3 * straight, elevation),
            BodyCamera(box, 0, -straight)};
}

QRect sideBox(int side, QSize tile) {
    return {QPoint(side % sideColumns * tile.width(), side / sideColumns * tile.height()), tile};
}

float commonSpan(const std::vector<BodyCamera>& cameras, const TriangleMesh& mesh, QSize tile) {
    float span = 0;
    for (const BodyCamera& camera : cameras) {
        span = std::max(span, marginFactor * camera.span(mesh, tile));
    }
    return span;
}

SurfacePoint middleOf(const SeenBody& body, int x, int y) {
    return body.at(samplesAcross * x + samplesAcross / 2, samplesAcross * y + samplesAcross / 2);
}

void drawView(QImage& picture, const QRect& tile, const SeenBody& body, const RayLight& light,
              const BodyCamera& camera, float span, const CancelToken& cancelToken) {
    const View view(body, light, camera, span, tile.size());
    uchar* bits = picture.bits();
    const qsizetype stride = picture.bytesPerLine();
    parallelFor(0, tile.height(), [&](int y) {
        if (cancelToken.isCancelled()) {
            return;
        }
        uchar* out = bits + (tile.y() + y) * stride + qsizetype(tile.x()) * 3;
        for (int x = 0; x < tile.width(); ++x, out += 3) {
            const PixelBytes pixel = view.pixel(x, y);
            std::copy(pixel.begin(), pixel.end(), out);
        }
    });
    cancelToken.throwIfCancelled();
}

void nameSides(QPainter& painter, QSize tile) {
    const QStringList names{Text::tr("Front"), Text::tr("Right"), Text::tr("From above"),
                            Text::tr("Back"),  Text::tr("Left"),  Text::tr("From below")};
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(std::max(8, tile.height() / 20));
    painter.setFont(font);
    painter.setPen(QColor(95, 100, 106));
    const int inset = tile.height() / 32;
    for (int side = 0; side < names.size(); ++side) {
        painter.drawText(sideBox(side, tile).adjusted(inset, inset, -inset, -inset),
                         Qt::AlignLeft | Qt::AlignTop, names[side]);
    }
    painter.setPen(QColor(208, 211, 214));
    for (int column = 1; column < sideColumns; ++column) {
        painter.drawLine(column * tile.width(), 0, column * tile.width(), 2 * tile.height());
    }
    painter.drawLine(0, tile.height(), sideColumns * tile.width(), tile.height());
}

} // namespace dipwright
