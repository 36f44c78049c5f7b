#include "results/Portrait.h"

#include "dip/FilmMarks.h"
#include "parallel/ParallelFor.h"
#include "results/BodyViews.h"
#include "results/FilmPlaces.h"
#include "results/Hatch.h"
#include "results/PaintedBody.h"
#include "results/ProofScene.h"

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

const LinearColour table(0.93f, 0.935f, 0.94f);
constexpr float elevation =
    22 * std::numbers::pi_v<float> / 180; // camera over the horizon, radians

// Computes the light from the table, the body and its paint.
class Scene {
public:
    Scene(const ProofStage& stage, const std::vector<FilmAppearance>& films,
          const ProofOptions& options)
        : mesh_(stage.mesh),
          fine_(tablePays(*stage.fine, 6.0 * options.tile.width() * options.tile.height())
                    ? stage.fine.get()
                    : nullptr),
          normals_(stage.normals), sky_(stage.sky), middle_(stage.box.center()),
          size_(stage.box.diagonal().norm()), films_(films, options.ink, options.ground, fine_) {
        for (const FilmAppearance& appearance : films) {
            marks_ |= paintedMarks(*appearance.laid);
        }
    }

    // Returns the solver::PointMark bits of all films.
    std::uint8_t marks() const { return marks_; }
    // Returns the mesh that pictures show. Places below are of this mesh.
    const TriangleMesh& mesh() const { return fine_ ? fine_->mesh() : mesh_; }

    // Returns the most serious mark of the last dipped film at a place.
    std::optional<solver::PointMark> mark(const SurfacePoint& seen) const {
        const auto marks = seen.isValid() ? films_.marks(seen) : std::nullopt;
        return marks ? mostSeriousMark(*marks) : std::nullopt;
    }

    // Returns the light along a ray that meets the body at `seen`.
    LinearColour light(const BodyRay& ray, const SurfacePoint& seen,
                       const BodyCamera& camera) const {
        return seen.isValid() ? bodyLight(seen, ray, camera) : tableLight(ray);
    }

private:
    LinearColour bodyLight(const SurfacePoint& seen, const BodyRay& ray,
                           const BodyCamera& camera) const {
        const LinearColour colour = films_.colour(seen);
        const SurfacePoint point = fine_ ? fine_->onCoarse(seen) : seen;
        Eigen::Vector3f normal = normalAt(normals_, point);
        if (normal.dot(ray.direction) > 0) {
            normal = -normal;
        }
        // The light comes from a softbox over the photographer's left shoulder and from a bright
        // room.
        const Eigen::Vector3f lamp =
            (0.5f * camera.up() - 0.45f * camera.right() - ray.direction).normalized();
        const float facing = std::max(0.0f, 0.25f + 0.75f * normal.dot(lamp));
        // A camera below the table sees through the table.
        const float open = camera.isBelow() ? 1 : sky_.onBody(point);
        const float room = open * (0.75f + 0.25f * (camera.isBelow() ? -normal.y() : normal.y()));
        const Eigen::Vector3f halfway = (lamp - ray.direction).normalized();
        const float gloss = 0.05f * std::pow(std::max(0.0f, normal.dot(halfway)), 60.0f);
        return colour * (0.5f * facing + 0.56f * room) + gloss;
    }

    LinearColour tableLight(const BodyRay& ray) const {
        if (ray.direction.y() > 0) {
            return table;
        }
        const float height = sky_.tableHeight() - ray.origin.y();
        const Eigen::Vector3f place = ray.origin + ray.direction * (height / ray.direction.y());
        const float far = (place - middle_).norm() / size_;
        const float vignette = 1 - 0.035f * std::clamp(far - 0.5f, 0.0f, 2.0f);
        const float open = sky_.onTable(place.x(), place.z());
        return table * vignette * (0.3f + 0.7f * open);
    }

    const TriangleMesh& mesh_;
    const RefinedMesh* fine_; // null: the picture is small, and mesh_ is faster
    const CornerNormals& normals_;
    const SkyLight& sky_;
    Eigen::Vector3f middle_;
    float size_;
    PaintedBody films_;
    std::uint8_t marks_ = 0;
};

// Hatches the area that marked film paints in one tile of the picture.
void hatchView(QImage& picture, const QRect& tile, const Scene& scene, const SeenBody& body) {
    const Hatch hatch(picture.height());
    uchar* bits = picture.bits();
    const qsizetype stride = picture.bytesPerLine();
    parallelFor(0, tile.height(), [&](int y) {
        uchar* out = bits + (tile.y() + y) * stride + qsizetype(tile.x()) * 3;
        for (int x = 0; x < tile.width(); ++x, out += 3) {
            const auto mark = hatch.isOn(x, y) ? scene.mark(middleOf(body, x, y)) : std::nullopt;
            if (mark) {
                const QColor colour = hatch.colour(x, y, *mark);
                out[0] = uchar(colour.red());
                out[1] = uchar(colour.green());
                out[2] = uchar(colour.blue());
            }
        }
    });
}

// Draws a legend of the hatches along the picture's lower edge.
void drawMarks(QImage& picture, std::uint8_t marks) {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(std::max(8, picture.height() / 64));
    painter.setFont(font);
    painter.setPen(QColor(60, 64, 70));
    const double line = painter.fontMetrics().height();
    QPointF place(line, picture.height() - 1.8 * line);
    for (const solver::PointMark mark : filmMarks) {
        if (has(marks, mark)) {
            const QString text = markText(mark);
            paintHatched(painter, QRectF(place, QSizeF(1.8 * line, line)), mark);
            place.rx() += 2.3 * line;
            painter.drawText(place + QPointF(0, painter.fontMetrics().ascent()), text);
            place.rx() += painter.fontMetrics().horizontalAdvance(text) + 1.5 * line;
        }
    }
}

} // namespace

std::shared_ptr<const ProofStage> proofStage(const TexturedMesh& model,
                                             std::shared_ptr<const RefinedMesh> fine) {
    return std::make_shared<const ProofStage>(model.mesh, std::move(fine));
}

const SurfaceQuery& queryOf(const ProofStage& stage) {
    return stage.query;
}

QImage proofPicture(const ProofStage& stage, const std::vector<FilmAppearance>& films,
                    const ProofOptions& options, const Progress& progress) {
    progress(0, Text::tr("Preparing the proof"));
    const Scene scene(stage, films, options);
    const std::vector<BodyCamera> cameras = sixSides(stage.box, elevation);
    const float span = commonSpan(cameras, stage.mesh, options.tile);
    QImage picture(sideColumns * options.tile.width(), 2 * options.tile.height(),
                   QImage::Format_RGB888);
    for (int side = 0; side < int(cameras.size()); ++side) {
        progress(0.1 + 0.15 * side, Text::tr("Drawing the proof"));
        const BodyCamera& camera = cameras[std::size_t(side)];
        const QRect tile = sideBox(side, options.tile);
        const SeenBody body = camera.see(scene.mesh(), span, tile.size());
        const RayLight light = [&](const BodyRay& ray, const SurfacePoint& seen) {
            return scene.light(ray, seen, camera);
        };
        drawView(picture, tile, body, light, camera, span, progress.cancelToken);
        if (scene.marks() != 0) {
            hatchView(picture, tile, scene, body);
        }
    }
    QPainter painter(&picture);
    nameSides(painter, options.tile);
    painter.end();
    drawMarks(picture, scene.marks());
    return picture;
}

QImage portraitPicture(const ProofStage& stage, const std::vector<FilmAppearance>& films,
                       const ProofOptions& options, const Eigen::Vector3f& towards,
                       const CancelToken& cancelToken) {
    constexpr float steepest = 40 * std::numbers::pi_v<float> / 180;
    constexpr float room = 1.08f; // around the body
    const float rise = std::asin(std::clamp(towards.normalized().y(), -1.0f, 1.0f));
    const BodyCamera camera(stage.box, std::atan2(towards.x(), towards.z()),
                            std::clamp(rise, -steepest, steepest));
    const Scene scene(stage, films, options);
    const float span = room * camera.span(stage.mesh, options.tile);
    QImage picture(options.tile, QImage::Format_RGB888);
    drawView(
        picture, picture.rect(), camera.see(scene.mesh(), span, options.tile),
        [&](const BodyRay& ray, const SurfacePoint& seen) {
            return scene.light(ray, seen, camera);
        },
        camera, span, cancelToken);
    return picture;
}

} // namespace dipwright
