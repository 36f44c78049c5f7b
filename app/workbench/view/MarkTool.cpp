#include "workbench/view/MarkTool.h"

namespace dipwright {
namespace {

constexpr double marksApart = 0.6; // times the brush's radius, along a stroke

// Returns the radius of a mark in mm. 0: the mark covers a whole face or material.
double reach(const ShareMark& mark) {
    return mark.radius.value();
}

double reach(const ZoneMark& mark) {
    return mark.extent == ZoneExtent::Spot ? mark.radius.value() : 0;
}

} // namespace

MarkTool::MarkTool(DipView& view, const DipScene& scene, const DipSession& session, QObject* parent)
    : QObject(parent), scene_(scene), session_(session) {
    view.addStroke([this](const ViewRay& ray) { return begins(ray); });
    connect(&view, &DipView::stroked, this, &MarkTool::stroke);
    connect(&view, &DipView::strokeFinished, this, &MarkTool::finish);
}

// A drag beside the body turns the camera.
bool MarkTool::begins(const ViewRay& ray) {
    if (std::holds_alternative<std::monostate>(brush_) || !session_.document() ||
        !scene_.modelPoint(ray)) {
        return false;
    }
    emit begun();
    return true;
}

void MarkTool::stroke(const ViewRay& ray) {
    const auto place = session_.document() ? scene_.modelPoint(ray) : std::nullopt;
    if (!place) {
        return;
    }
    const auto add = [&]<typename Mark>(Mark mark) {
        if constexpr (!std::is_same_v<Mark, std::monostate>) {
            // A face's mark has no reach: a stroke marks only the face where it begins.
            const double apart = marksApart * reach(mark);
            if (last_ && (apart <= 0 || double((*place - *last_).norm()) < apart)) {
                return;
            }
            last_ = place;
            for (int axis = 0; axis < 3; ++axis) {
                mark.place[std::size_t(axis)] = Millimetres(double((*place)[axis]));
            }
            addMark(*session_.document(), mark);
        }
    };
    std::visit(add, brush_);
}

void MarkTool::finish() {
    last_.reset();
    if (session_.document()) {
        session_.document()->endMerge();
    }
    emit ended();
}

} // namespace dipwright
