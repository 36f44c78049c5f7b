#include "traveller/PosePicture.h"

#include "parallel/ParallelFor.h"
#include "results/AdaptiveSampling.h"

#include <algorithm>
#include <optional>

namespace dipwright {
namespace {

constexpr int samplesAcross = 2; // rays per pixel along each axis
constexpr double room = 1.06;    // picture size divided by body size
const Eigen::Array3f bareBody(0.78F, 0.78F, 0.76F), cradleColour(0.93F, 0.80F, 0.55F);

class Drawing {
public:
    Drawing(const PoseView& view, PoseSide side, QSize size) : view_(view), size_(size) {
        BoundingBox box = boundingBox(view.body.mesh);
        if (view.cradle && !view.cradle->triangles.empty()) {
            cradle_.emplace(*view.cradle);
            box.extend(boundingBox(*view.cradle));
        }
        right_ = side == PoseSide::Front   ? Eigen::Vector3f(1, 0, 0)
                 : side == PoseSide::Right ? Eigen::Vector3f(0, 0, -1)
                                           : Eigen::Vector3f(-1, 0, 0);
        back_ = side == PoseSide::Front   ? Eigen::Vector3f(0, 0, 1)
                : side == PoseSide::Right ? Eigen::Vector3f(1, 0, 0)
                                          : Eigen::Vector3f(0, -1, 0);
        up_ = back_.cross(right_);
        middle_ = box.center();
        away_ = box.diagonal().norm();
        const float width = std::abs(box.diagonal().dot(right_)),
                    height = std::abs(box.diagonal().dot(up_));
        scale_ = float(std::min(size.width() / (room * double(width)),
                                size.height() / (room * double(height))));
    }

    PixelBytes middleOf(int x, int y) const {
        return bytes(colour(float(x) + 0.5F, float(y) + 0.5F));
    }
    PixelBytes meanOf(int x, int y) const {
        Eigen::Array3f sum = Eigen::Array3f::Zero();
        for (int j = 0; j < samplesAcross; ++j) {
            for (int i = 0; i < samplesAcross; ++i) {
                sum += colour(float(x) + (float(i) + 0.5F) / samplesAcross,
                              float(y) + (float(j) + 0.5F) / samplesAcross);
            }
        }
        return bytes(sum / (samplesAcross * samplesAcross));
    }

    double scale() const { return double(scale_); }
    double bottom() const { return double(middle_.y()) - size_.height() / 2.0 / double(scale_); }

private:
    static PixelBytes bytes(const Eigen::Array3f& colour) {
        const auto byte = [](float share) { return std::uint8_t(255.0F * share + 0.5F); };
        return {byte(colour[0]), byte(colour[1]), byte(colour[2])};
    }

    Eigen::Array3f colour(float x, float y) const {
        const Eigen::Vector3f origin = middle_ + away_ * back_ +
                                       (x - float(size_.width()) / 2) / scale_ * right_ +
                                       (float(size_.height()) / 2 - y) / scale_ * up_;
        const RayHit body = view_.body.query.hit(origin, -back_);
        const RayHit cradle = cradle_ ? cradle_->hit(origin, -back_) : RayHit();
        if (cradle.point.isValid() && cradle.distance < body.distance) {
            return lit(cradleColour, triangleNormal(*view_.cradle, cradle.point.triangle));
        }
        if (!body.point.isValid()) {
            return Eigen::Array3f::Ones();
        }
        return lit(filmColour(body.point), triangleNormal(view_.body.mesh, body.point.triangle));
    }

    static Eigen::Array3f channels(const QColor& colour) {
        return {colour.redF(), colour.greenF(), colour.blueF()};
    }
    // `u` and `v` run from 0 to 1, from the upper left corner.
    static QColor pixelOf(const QImage& image, double u, double v) {
        return image.pixelColor(std::clamp(int(u * image.width()), 0, image.width() - 1),
                                std::clamp(int(v * image.height()), 0, image.height() - 1));
    }

    Eigen::Array3f filmColour(const SurfacePoint& point) const {
        for (auto film = view_.films.rbegin(); film != view_.films.rend(); ++film) {
            if (const auto place = film->laid->place(point)) {
                const solver::FilmGrid& grid = film->laid->film().grid;
                const double u = double(place->rest.x()) / grid.width + 0.5;
                const double v = double(place->rest.y()) / grid.depth + 0.5;
                const QColor printed = pixelOf(film->image, u, v);
                if (printed.alpha() > 127) {
                    Eigen::Array3f light = channels(printed);
                    for (const PrintedSpot& spot : film->spots) {
                        const float tint = float(pixelOf(spot.tints, u, v).redF());
                        light *= 1 - tint * (1 - channels(spot.colour));
                    }
                    return light;
                }
            }
        }
        return bareBody;
    }

    // Returns the colour of the surface in the light of a lamp over the viewer's left shoulder.
    Eigen::Array3f lit(const Eigen::Array3f& colour, const Eigen::Vector3f& normal) const {
        const Eigen::Vector3f lamp = (back_ - 0.5F * right_ + 0.6F * up_).normalized();
        return colour * (0.55F + 0.45F * std::max(0.0F, normal.dot(lamp)));
    }

    const PoseView& view_;
    QSize size_;
    std::optional<SurfaceQuery> cradle_;
    Eigen::Vector3f right_, up_, back_, middle_;
    float away_ = 0, scale_ = 1;
};

} // namespace

PosePicture posePicture(const PoseView& view, PoseSide side, QSize size, const Progress& progress) {
    const Drawing drawing(view, side, size);
    PosePicture result{QImage(size, QImage::Format_RGB32), drawing.scale(), drawing.bottom()};
    const auto width = std::size_t(size.width());
    std::vector<PixelBytes> middles(width * std::size_t(size.height()));
    parallelFor(0, size.height(), [&](int y) {
        progress.cancelToken.throwIfCancelled();
        for (int x = 0; x < size.width(); ++x) {
            middles[std::size_t(y) * width + std::size_t(x)] = drawing.middleOf(x, y);
        }
    });
    uchar* const bits = result.image.bits();
    const qsizetype line = result.image.bytesPerLine();
    parallelFor(0, size.height(), [&](int y) {
        progress.cancelToken.throwIfCancelled();
        auto* const row = reinterpret_cast<QRgb*>(bits + y * line);
        for (int x = 0; x < size.width(); ++x) {
            const auto [red, green, blue] = isEven(middles, size, x, y)
                                                ? middles[std::size_t(y) * width + std::size_t(x)]
                                                : drawing.meanOf(x, y);
            row[x] = qRgb(red, green, blue);
        }
    });
    return result;
}

} // namespace dipwright
