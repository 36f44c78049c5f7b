#include "parallel/ParallelFor.h"
#include "results/Results.h"

#include "dip/FilmMarks.h"
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
constexpr int samplesAcross = 3;                                  // of a pixel, both ways
constexpr float elevation = 22 * std::numbers::pi_v<float> / 180; // of the camera over the horizon

struct Ray {
    Eigen::Vector3f origin, direction;
};

// Looks at a body's middle from a side, a little from above.
class Camera {
public:
    // `turn`: radians from the front (0) to the right (a quarter turn) and on.
    Camera(const BoundingBox& box, float turn)
        : middle_(box.center()), back_(std::sin(turn) * std::cos(elevation), std::sin(elevation),
                                       std::cos(turn) * std::cos(elevation)),
          right_(std::cos(turn), 0, -std::sin(turn)), up_(back_.cross(right_)),
          distance_(3.2f * box.diagonal().norm()) {}

    // Half the height of the view, at unit distance, that shows all of `mesh` in a `tile`.
    float span(const TriangleMesh& mesh, QSize tile) const {
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

    // x, y: −1 … 1 from left to right and bottom to top of a view of that span and aspect.
    Ray ray(float x, float y, float span, float aspect) const {
        return {middle_ + distance_ * back_,
                (-back_ + span * (x * aspect * right_ + y * up_)).normalized()};
    }

    const Eigen::Vector3f& right() const { return right_; }
    const Eigen::Vector3f& up() const { return up_; }

private:
    Eigen::Vector3f middle_, back_, right_, up_;
    float distance_;
};

// The light that the table, the body and its paint send along a ray.
class Scene {
public:
    Scene(const ProofStage& stage, const std::vector<WornFilm>& films, bool compensatedInk)
        : query_(stage.query), normals_(stage.normals), sky_(stage.sky),
          middle_(stage.box.center()), size_(stage.box.diagonal().norm()),
          films_(films, compensatedInk) {
        for (const WornFilm& worn : films) {
            marks_ |= paintedMarks(*worn.laid);
        }
    }

    // solver::PointMark bits of any film.
    std::uint8_t marks() const { return marks_; }
    // How the paint is marked that a ray meets first, that of the film that was dipped last.
    std::optional<solver::PointMark> mark(const Ray& ray) const {
        const RayHit hit = query_.hit(ray.origin, ray.direction);
        const auto marks = hit.point.isValid() ? films_.marks(hit.point) : std::nullopt;
        return marks ? gravestMark(*marks) : std::nullopt;
    }

    LinearColour light(const Ray& ray, const Camera& camera) const {
        const RayHit hit = query_.hit(ray.origin, ray.direction);
        return hit.point.isValid() ? bodyLight(hit.point, ray, camera) : tableLight(ray);
    }

private:
    LinearColour bodyLight(const SurfacePoint& point, const Ray& ray, const Camera& camera) const {
        const LinearColour colour = films_.colour(point);
        Eigen::Vector3f normal = normalAt(normals_, point);
        if (normal.dot(ray.direction) > 0) {
            normal = -normal;
        }
        // A softbox over the photographer's left shoulder and a bright room.
        const Eigen::Vector3f lamp =
            (0.5f * camera.up() - 0.45f * camera.right() - ray.direction).normalized();
        const float facing = std::max(0.0f, 0.25f + 0.75f * normal.dot(lamp));
        const float room = sky_.onBody(point) * (0.75f + 0.25f * normal.y());
        const Eigen::Vector3f halfway = (lamp - ray.direction).normalized();
        const float gloss = 0.05f * std::pow(std::max(0.0f, normal.dot(halfway)), 60.0f);
        return colour * (0.5f * facing + 0.56f * room) + gloss;
    }

    LinearColour tableLight(const Ray& ray) const {
        const float height = sky_.tableHeight() - ray.origin.y();
        const Eigen::Vector3f place = ray.origin + ray.direction * (height / ray.direction.y());
        const float far = (place - middle_).norm() / size_;
        const float vignette = 1 - 0.035f * std::clamp(far - 0.5f, 0.0f, 2.0f);
        const float open = sky_.onTable(place.x(), place.z());
        return table * vignette * (0.3f + 0.7f * open);
    }

    const SurfaceQuery& query_;
    const CornerNormals& normals_;
    const SkyLight& sky_;
    Eigen::Vector3f middle_;
    float size_;
    PaintedBody films_;
    std::uint8_t marks_ = 0;
};

// One view of the scene as light a pixel. Most pixels show light that hardly changes: one ray tells
// theirs, and only where neighbours differ a pixel is worth many.
class View {
public:
    View(const Scene& scene, const Camera& camera, float span, QSize size)
        : scene_(scene), camera_(camera), span_(span), size_(size),
          centres_(std::size_t(size.width()) * std::size_t(size.height())),
          shown_(centres_.size()) {
        parallelFor(0, size.height(), [&](int y) {
            for (int x = 0; x < size.width(); ++x) {
                const std::size_t at = index(x, y);
                centres_[at] = sample(float(x) + 0.5f, float(y) + 0.5f);
                shown_[at] = encoded(centres_[at]);
            }
        });
    }

    using Pixel = std::array<std::uint8_t, 3>;
    Pixel pixel(int x, int y) const {
        return isEven(x, y) ? shown_[index(x, y)] : encoded(meanLight(x, y));
    }
    std::optional<solver::PointMark> mark(int x, int y) const {
        return scene_.mark(ray(float(x) + 0.5f, float(y) + 0.5f));
    }

private:
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(size_.width()) + std::size_t(x);
    }

    static Pixel encoded(const LinearColour& light) {
        return {encodedByte(light[0]), encodedByte(light[1]), encodedByte(light[2])};
    }

    // Through a place of the view, in pixels.
    Ray ray(float x, float y) const {
        const float aspect = float(size_.width()) / float(size_.height());
        const float right = x / float(size_.width());
        const float down = y / float(size_.height());
        return camera_.ray(2 * right - 1, 1 - 2 * down, span_, aspect);
    }

    LinearColour sample(float x, float y) const {
        return scene_.light(ray(x, y), camera_)
            .min(1.0f); // before any mean, so that edges of highlights stay smooth
    }

    LinearColour meanLight(int x, int y) const {
        LinearColour sum = LinearColour::Zero();
        for (int j = 0; j < samplesAcross; ++j) {
            for (int i = 0; i < samplesAcross; ++i) {
                const bool isCentre = 2 * i + 1 == samplesAcross && 2 * j + 1 == samplesAcross;
                sum += isCentre ? centres_[index(x, y)]
                                : sample(float(x) + (float(i) + 0.5f) / samplesAcross,
                                         float(y) + (float(j) + 0.5f) / samplesAcross);
            }
        }
        return sum / float(samplesAcross * samplesAcross);
    }

    bool isEven(int x, int y) const {
        const Pixel& centre = shown_[index(x, y)];
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size_.height() - 1); ++j) {
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size_.width() - 1); ++i) {
                const Pixel& other = shown_[index(i, j)];
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    if (std::abs(int(centre[channel]) - int(other[channel])) > unseenStep) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    static constexpr int unseenStep = 2; // of 255 between neighbours

    const Scene& scene_;
    const Camera& camera_;
    float span_;
    QSize size_;
    std::vector<LinearColour> centres_; // the light in the pixels' middles
    std::vector<Pixel> shown_;          // the same as a picture has it
};

// Over what marked film paints, in row `y` of a view; `out`: that row's pixels.
void hatchRow(uchar* out, int y, const Hatch& hatch, const View& view, int width) {
    for (int x = 0; x < width; ++x, out += 3) {
        const auto mark = hatch.isOn(x, y) ? view.mark(x, y) : std::nullopt;
        if (mark) {
            const QColor colour = hatch.colour(x, y, *mark);
            out[0] = uchar(colour.red());
            out[1] = uchar(colour.green());
            out[2] = uchar(colour.blue());
        }
    }
}

void traceView(QImage& picture, const QRect& tile, const Scene& scene, const Camera& camera,
               float span, const Progress& progress) {
    const View view(scene, camera, span, tile.size());
    uchar* bits = picture.bits();
    const qsizetype stride = picture.bytesPerLine();
    const Hatch hatch(picture.height());
    parallelFor(0, tile.height(), [&](int y) {
        if (progress.cancelSwitch.isCancelled()) {
            return;
        }
        uchar* row = bits + (tile.y() + y) * stride + qsizetype(tile.x()) * 3;
        uchar* out = row;
        for (int x = 0; x < tile.width(); ++x, out += 3) {
            const View::Pixel pixel = view.pixel(x, y);
            std::copy(pixel.begin(), pixel.end(), out);
        }
        if (scene.marks() != 0) {
            hatchRow(row, y, hatch, view, tile.width());
        }
    });
    progress.cancelSwitch.throwIfCancelled();
}

void drawNames(QImage& picture, QSize tile, const QStringList& names) {
    QPainter painter(&picture);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(std::max(8, tile.height() / 20));
    painter.setFont(font);
    painter.setPen(QColor(95, 100, 106));
    for (int view = 0; view < names.size(); ++view) {
        const QRect box(QPoint(view % 2 * tile.width(), view / 2 * tile.height()), tile);
        const int inset = tile.height() / 32;
        painter.drawText(box.adjusted(inset, inset, -inset, -inset), Qt::AlignLeft | Qt::AlignTop,
                         names[view]);
    }
    painter.setPen(QColor(208, 211, 214));
    painter.drawLine(tile.width(), 0, tile.width(), picture.height());
    painter.drawLine(0, tile.height(), picture.width(), tile.height());
}

// What the hatches mean that are in the picture, along its lower edge.
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

std::shared_ptr<const ProofStage> proofStage(const TexturedMesh& model) {
    return std::make_shared<const ProofStage>(model.mesh);
}

QImage proofPicture(const ProofStage& stage, const std::vector<WornFilm>& films,
                    const ProofOptions& options, const Progress& progress) {
    progress(0, Text::tr("Preparing the proof"));
    const Scene scene(stage, films, options.compensatedInk);
    std::vector<Camera> cameras;
    float span = 0;
    for (int view = 0; view < 4; ++view) {
        cameras.emplace_back(stage.box, float(view) * std::numbers::pi_v<float> / 2);
        span = std::max(span, 1.22f * cameras.back().span(stage.mesh, options.tile));
    }
    QImage picture(options.tile * 2, QImage::Format_RGB888);
    for (int view = 0; view < 4; ++view) {
        progress(0.1 + 0.22 * view, Text::tr("Tracing the proof"));
        const QPoint corner(view % 2 * options.tile.width(), view / 2 * options.tile.height());
        traceView(picture, QRect(corner, options.tile), scene, cameras[std::size_t(view)], span,
                  progress);
    }
    drawNames(picture, options.tile,
              {Text::tr("Front"), Text::tr("Right"), Text::tr("Back"), Text::tr("Left")});
    drawMarks(picture, scene.marks());
    return picture;
}

} // namespace dipwright
