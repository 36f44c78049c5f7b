#include "traveller/PosePicture.h"

#include "marks/MaskColour.h"
#include "parallel/ParallelFor.h"
#include "results/AdaptiveSampling.h"
#include "results/SeenBody.h"

#include <algorithm>
#include <optional>

namespace dipwright {
namespace {

constexpr int samplesAcross = 3; // samples per pixel along each axis; odd
constexpr double room = 1.06;    // picture size divided by body size
const Eigen::Array3f cradleColour(0.93F, 0.80F, 0.55F);

// Returns the positions of a refined mesh in the pose frame.
TriangleMesh posed(const RefinedMesh& fine, const PosedBody& body) {
    TriangleMesh mesh = fine.mesh();
    for (Eigen::Vector3f& position : mesh.positions) {
        position = (body.modelToPose * position.cast<double>()).cast<float>();
    }
    return mesh;
}

// A parallel projection that shows body and cradle.
struct Projection {
    Eigen::Vector3f right, up, back, middle;
    float scale = 1; // pixels per mm

    Projection(const BoundingBox& box, PoseSide side, QSize size)
        : right(side == PoseSide::Front   ? Eigen::Vector3f(1, 0, 0)
                : side == PoseSide::Right ? Eigen::Vector3f(0, 0, -1)
                                          : Eigen::Vector3f(-1, 0, 0)),
          back(side == PoseSide::Front   ? Eigen::Vector3f(0, 0, 1)
               : side == PoseSide::Right ? Eigen::Vector3f(1, 0, 0)
                                         : Eigen::Vector3f(0, -1, 0)),
          middle(box.center()) {
        up = back.cross(right);
        const float width = std::abs(box.diagonal().dot(right)),
                    height = std::abs(box.diagonal().dot(up));
        scale = float(std::min(size.width() / (room * double(width)),
                               size.height() / (room * double(height))));
    }

    SeenBody see(const TriangleMesh& mesh, QSize size) const {
        std::vector<ViewedPoint> points;
        points.reserve(mesh.positions.size());
        for (const Eigen::Vector3f& position : mesh.positions) {
            const Eigen::Vector3f offset = (position - middle) * scale;
            points.push_back({samplesAcross * (size.width() / 2.0 + double(offset.dot(right))),
                              samplesAcross * (size.height() / 2.0 - double(offset.dot(up))),
                              double(offset.dot(back))});
        }
        return {mesh, std::move(points), samplesAcross * size};
    }
};

class Drawing {
public:
    Drawing(const PoseView& view, PoseSide side, QSize size)
        : view_(view), fine_(posed(view.fine, view.body)), projection_(boxOf(view), side, size),
          body_(projection_.see(fine_, size)) {
        if (hasCradle(view)) {
            cradle_.emplace(projection_.see(*view.cradle, size));
        }
    }

    PixelBytes middleOf(int x, int y) const {
        return bytes(
            colour(samplesAcross * x + samplesAcross / 2, samplesAcross * y + samplesAcross / 2));
    }
    PixelBytes meanOf(int x, int y) const {
        Eigen::Array3f sum = Eigen::Array3f::Zero();
        for (int j = 0; j < samplesAcross; ++j) {
            for (int i = 0; i < samplesAcross; ++i) {
                sum += colour(samplesAcross * x + i, samplesAcross * y + j);
            }
        }
        return bytes(sum / (samplesAcross * samplesAcross));
    }

    double scale() const { return double(projection_.scale); }
    // Returns the y of the lower edge of a picture of this height, pose frame, mm.
    double bottom(int height) const {
        return double(projection_.middle.y()) - height / 2.0 / double(projection_.scale);
    }

private:
    static bool hasCradle(const PoseView& view) {
        return view.cradle && !view.cradle->triangles.empty();
    }
    static BoundingBox boxOf(const PoseView& view) {
        BoundingBox box = boundingBox(view.body.mesh);
        return hasCradle(view) ? box.extend(boundingBox(*view.cradle)) : box;
    }

    static PixelBytes bytes(const Eigen::Array3f& colour) {
        const auto byte = [](float share) { return std::uint8_t(255.0F * share + 0.5F); };
        return {byte(colour[0]), byte(colour[1]), byte(colour[2])};
    }

    // Returns the colour of a sample point.
    Eigen::Array3f colour(int column, int row) const {
        if (cradle_ && cradle_->nearness(column, row) > body_.nearness(column, row)) {
            const SurfacePoint point = cradle_->at(column, row);
            return lit(cradleColour, triangleNormal(*view_.cradle, point.triangle));
        }
        const SurfacePoint point = body_.at(column, row);
        return point.isValid() ? lit(ownColour(point), triangleNormal(fine_, point.triangle))
                               : Eigen::Array3f::Ones();
    }

    Eigen::Array3f ownColour(const SurfacePoint& point) const {
        const bool isTaped = view_.mask && view_.mask->covers(view_.fine.onCoarse(point));
        const QColor colour =
            isTaped ? maskColour : QColor(encodedPixel(view_.paint.colour(point)));
        return {colour.redF(), colour.greenF(), colour.blueF()};
    }

    // Returns the colour of the surface in the light of a lamp over the viewer's left shoulder.
    Eigen::Array3f lit(const Eigen::Array3f& colour, const Eigen::Vector3f& normal) const {
        const Eigen::Vector3f lamp =
            (projection_.back - 0.5F * projection_.right + 0.6F * projection_.up).normalized();
        return colour * (0.55F + 0.45F * std::max(0.0F, normal.dot(lamp)));
    }

    const PoseView& view_;
    TriangleMesh fine_; // in the pose frame
    Projection projection_;
    SeenBody body_;
    std::optional<SeenBody> cradle_;
};

} // namespace

PosePicture posePicture(const PoseView& view, PoseSide side, QSize size, const Progress& progress) {
    const Drawing drawing(view, side, size);
    PosePicture result{QImage(size, QImage::Format_RGB32), drawing.scale(),
                       drawing.bottom(size.height())};
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
