#include "workbench/view/MarkTool.h"

#include "marks/MaskColour.h"
#include "workbench/accuracy/ZoneAppearance.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

// Distances along a stroke, relative to the brush's radius.
constexpr float pointsApart = 0.2f; // between points of its path
constexpr float raysApart = 0.5f;   // between rays, while the mouse moves fast
constexpr float jump = 2;           // a longer way between two points interrupts the stroke
constexpr int mostRays = 40;        // for one move of the mouse
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
        show({}, 0);
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
    emit begun();
    return true;
}

void MarkTool::stroke(const ViewRay& ray) {
    const auto place = scene_.modelSurface(ray);
    if (std::holds_alternative<std::monostate>(drawn_) || !session_.document()) {
        return;
    }
    if (!drawsStrokes(drawn_)) { // marks only the face where the drag begins
        if (place && !lastRay_) {
            addMark(*session_.document(), drawn_, pointAt(*place).place);
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
    const bool isDrawn = !std::holds_alternative<std::monostate>(drawn_);
    if (session_.document() && !parts_.empty()) {
        std::vector<BrushPath> paths;
        for (const StrokePatch& part : parts_) {
            paths.push_back(part.path());
        }
        addStrokes(*session_.document(), drawn_, paths);
    }
    forget();
    if (isDrawn) {
        emit ended();
    }
}

void MarkTool::hover(const ViewRay& ray) {
    hovered_ = ray;
    if (!drawsStrokes(brush_)) {
        return;
    }
    std::vector<StrokePatch> dab;
    drawn_ = brushNow();
    if (const auto place = scene_.modelSurface(ray)) {
        dab.push_back(newPart());
        dab.back().add(pointAt(*place));
    }
    show(dab, hoverOpacity);
    drawn_ = {};
}

void MarkTool::forget() {
    parts_.clear();
    lastRay_.reset();
    drawn_ = {};
    show({}, 0);
}

void MarkTool::show(const std::vector<StrokePatch>& parts, int opacity) {
    ViewPatch patch{{}, colourOf(drawn_)};
    patch.colour.setAlpha(opacity);
    for (const StrokePatch& part : parts) {
        for (const MarkedPiece& piece : part.pieces()) {
            patch.triangles.push_back(piece.corners);
        }
    }
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

StrokePatch MarkTool::newPart() const {
    return {scene_.model()->mesh, *scene_.query(), radiusOf(drawn_)};
}

} // namespace dipwright
