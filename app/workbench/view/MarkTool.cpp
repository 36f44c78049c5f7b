#include "workbench/view/MarkTool.h"

#include "base/Error.h"
#include "marks/MaskColour.h"
#include "workbench/accuracy/ZoneAppearance.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <utility>

namespace dipwright {
namespace {

using Triangle = std::array<Eigen::Vector3f, 3>;

// Distances along a stroke, relative to the brush's radius.
constexpr float pointsApart = 0.2f;       // between points of its path
constexpr float raysApart = 0.5f;         // between rays, while the mouse moves fast
constexpr float jump = 2;                 // a longer way between two points interrupts the stroke
constexpr int mostRays = 40;              // for one move of the mouse
constexpr std::size_t mostHovered = 5000; // triangles that are cut while the mouse hovers
constexpr int strokeOpacity = 235, hoverOpacity = 120;

Millimetres radiusOf(const MarkBrush& brush) {
    return std::visit(
        [](const auto& mark) {
            if constexpr (std::is_same_v<std::decay_t<decltype(mark)>, std::monostate>) {
                return Millimetres(0);
            } else {
                return mark.radius;
            }
        },
        brush);
}

QColor colourOf(const MarkBrush& brush) {
    if (const auto* seam = std::get_if<ShareMark>(&brush)) {
        return shareMarkColour(seam->kind);
    }
    if (const auto* zone = std::get_if<ZoneMark>(&brush)) {
        return zoneColour(zone->zone);
    }
    const auto* mask = std::get_if<MaskMark>(&brush);
    return mask && !mask->erases ? maskColour : QColor(235, 235, 235);
}

// A flat ring.
std::vector<Triangle> circle(const Eigen::Vector3f& middle, const Eigen::Vector3f& outward,
                             float radius) {
    constexpr int sides = 64;
    constexpr float inner = 0.94f; // relative to the radius
    const Eigen::Vector3f right = outward.unitOrthogonal(), up = outward.cross(right);
    const auto at = [&](int side) -> Eigen::Vector3f {
        const float angle = float(2 * pi) * float(side) / sides;
        return radius * (std::cos(angle) * right + std::sin(angle) * up);
    };
    std::vector<Triangle> ring;
    for (int side = 0; side < sides; ++side) {
        const Eigen::Vector3f a = middle + at(side), b = middle + at(side + 1);
        const Eigen::Vector3f c = middle + inner * at(side), d = middle + inner * at(side + 1);
        ring.push_back({a, b, c});
        ring.push_back({c, b, d});
    }
    return ring;
}

double rounded(float value, double steps) {
    return std::round(double(value) * steps) / steps;
}

} // namespace

MarkTool::MarkTool(DipView& view, DipScene& scene, const DipSession& session, QObject* parent)
    : QObject(parent), scene_(scene), session_(session) {
    view.addStroke([this](const ViewRay& ray) { return begins(ray); });
    connect(&view, &DipView::stroked, this, &MarkTool::stroke);
    connect(&view, &DipView::strokeFinished, this, &MarkTool::finish);
    connect(&view, &DipView::hovered, this, &MarkTool::hover);
    connect(&view, &DipView::hoverLeft, this, [this] {
        hovered_.reset();
        scene_.setStroke({});
    });
}

void MarkTool::setBrush(const MarkBrush& brush) {
    brush_ = brush;
    forget();
    if (hovered_) {
        hover(*hovered_);
    }
}

MarkBrush MarkTool::brushNow() const {
    const bool isShiftHeld = QGuiApplication::keyboardModifiers() & Qt::ShiftModifier;
    return isShiftHeld && drawsStrokes(brush_) ? eraserOf(brush_) : brush_;
}

// A drag beside the body turns the camera.
bool MarkTool::begins(const ViewRay& ray) {
    if (std::holds_alternative<std::monostate>(brush_) || !session_.document() ||
        !scene_.modelPoint(ray)) {
        return false;
    }
    forget();
    drawn_ = brushNow();
    drawnOn_ = scene_.model();
    emit begun();
    return true;
}

void MarkTool::stroke(const ViewRay& ray) {
    if (drawnOn_ && drawnOn_ != scene_.model()) { // for example undone while the button is held
        forget();
    }
    if (std::holds_alternative<std::monostate>(drawn_) || !session_.document()) {
        return;
    }
    const auto place = scene_.modelSurface(ray);
    if (!drawsStrokes(drawn_)) { // marks only the face where the drag begins
        if (place && !lastRay_) {
            add([&] {
                addMark(*session_.document(), drawn_, pointAt(*place).place, faceAt(*place));
            });
        }
        lastRay_ = ray;
        return;
    }
    int rays = 1;
    if (place && lastRay_ && !parts_.empty()) {
        const Eigen::Vector3f way =
            position(scene_.model()->mesh, *place) - modelPlace(parts_.back().path().back().place);
        const float apart = raysApart * float(radiusOf(drawn_).value());
        rays = int(std::clamp(std::ceil(way.norm() / apart), 1.0f, float(mostRays)));
    }
    for (int number = 1; number < rays; ++number) {
        const float share = float(number) / float(rays);
        const ViewRay between{
            (1 - share) * lastRay_->origin + share * ray.origin,
            ((1 - share) * lastRay_->direction + share * ray.direction).normalized()};
        if (const auto onWay = scene_.modelSurface(between)) {
            addPoint(*onWay);
        }
    }
    if (place) {
        addPoint(*place);
    }
    lastRay_ = ray;
    show(parts_, strokeOpacity);
}

void MarkTool::addPoint(const SurfacePoint& place) {
    const BrushPoint point = pointAt(place);
    const auto radius = float(radiusOf(drawn_).value());
    const float way =
        parts_.empty()
            ? 0
            : (modelPlace(point.place) - modelPlace(parts_.back().path().back().place)).norm();
    if (parts_.empty() || way > jump * radius || parts_.back().path().size() >= mostBrushPoints) {
        parts_.push_back(newPart());
    } else if (way < pointsApart * radius) {
        return;
    }
    parts_.back().add(point);
}

void MarkTool::finish() {
    if (session_.document() && !parts_.empty() && drawnOn_ == scene_.model()) {
        std::vector<BrushPath> paths;
        for (const StrokePatch& part : parts_) {
            paths.push_back(part.path());
        }
        add([&] { addStrokes(*session_.document(), drawn_, paths); });
    }
    forget();
    if (std::exchange(drawnOn_, nullptr)) {
        emit ended();
    }
}

void MarkTool::add(const std::function<void()>& marks) {
    try {
        marks();
    } catch (const Error& error) {
        emit refused(error.sentence());
    }
}

void MarkTool::hover(const ViewRay& ray) {
    hovered_ = ray;
    if (!drawsStrokes(brush_)) {
        return;
    }
    drawn_ = brushNow();
    if (const auto place = scene_.modelSurface(ray)) {
        showDab(*place);
    } else {
        scene_.setStroke({});
    }
    drawn_ = {};
}

// A brush over very many triangles is shown as a circle.
void MarkTool::showDab(const SurfacePoint& place) {
    const TriangleMesh& mesh = scene_.model()->mesh;
    const Eigen::Vector3f middle = position(mesh, place);
    const auto radius = float(radiusOf(drawn_).value());
    if (scene_.query()->trianglesNear(middle, radius).size() > mostHovered) {
        show(circle(middle, triangleNormal(mesh, place.triangle), radius), hoverOpacity);
        return;
    }
    StrokePatch dab = newPart();
    dab.add(pointAt(place));
    show({dab}, hoverOpacity);
}

void MarkTool::forget() {
    parts_.clear();
    lastRay_.reset();
    drawn_ = {};
    scene_.setStroke({});
}

void MarkTool::show(const std::vector<StrokePatch>& parts, int opacity) {
    std::vector<Triangle> triangles;
    for (const StrokePatch& part : parts) {
        for (const MarkedPiece& piece : part.pieces()) {
            triangles.push_back(piece.corners);
        }
    }
    show(std::move(triangles), opacity);
}

void MarkTool::show(std::vector<Triangle> triangles, int opacity) {
    ViewPatch patch{std::move(triangles), colourOf(drawn_)};
    patch.colour.setAlpha(opacity);
    scene_.setStroke(std::move(patch));
}

// Rounds, so that the project file stays small.
BrushPoint MarkTool::pointAt(const SurfacePoint& place) const {
    constexpr double steps = 1000; // per mm, and per length of the normal
    const TriangleMesh& mesh = scene_.model()->mesh;
    const Eigen::Vector3f at = position(mesh, place), normal = triangleNormal(mesh, place.triangle);
    BrushPoint point;
    for (int axis = 0; axis < 3; ++axis) {
        point.place[std::size_t(axis)] = Millimetres(rounded(at[axis], steps));
        point.outward[std::size_t(axis)] = rounded(normal[axis], steps);
    }
    return point;
}

QString MarkTool::faceAt(const SurfacePoint& place) const {
    const TexturedMesh& model = *scene_.model();
    const bool isCad = !session_.document()->project().cad.name.isEmpty();
    return isCad ? model.materials[model.material[place.triangle]].name : QString();
}

StrokePatch MarkTool::newPart() const {
    return {scene_.model()->mesh, *scene_.query(), radiusOf(drawn_)};
}

} // namespace dipwright
