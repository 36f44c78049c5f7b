#include "view/JoinTool.h"

#include "document/ShareEdits.h"

namespace dipwright {
namespace {

constexpr double marksApart = 0.6; // of the brush's radius, along a stroke

} // namespace

JoinTool::JoinTool(DipView& view, const DipScene& scene, const DipSession& session, QObject* parent)
    : QObject(parent), scene_(scene), session_(session) {
    view.setStrokeBegin([this](const ViewRay& ray) { return begins(ray); });
    connect(&view, &DipView::stroked, this, &JoinTool::stroke);
    connect(&view, &DipView::strokeFinished, this, &JoinTool::finish);
}

// Beside the body a drag turns the camera.
bool JoinTool::begins(const ViewRay& ray) {
    if (!brush_ || !session_.document() || !scene_.modelPoint(ray)) {
        return false;
    }
    emit begun();
    return true;
}

void JoinTool::stroke(const ViewRay& ray) {
    const auto place = brush_ && session_.document() ? scene_.modelPoint(ray) : std::nullopt;
    // One face a stroke: a face is what was pressed, not what the cursor slid over.
    const double apart = marksApart * brush_.value_or(ShareMark{}).radius.value();
    if (!place || (last_ && (apart <= 0 || double((*place - *last_).norm()) < apart))) {
        return;
    }
    last_ = place;
    ShareMark mark = *brush_;
    for (int axis = 0; axis < 3; ++axis) {
        mark.place[std::size_t(axis)] = Millimetres(double((*place)[axis]));
    }
    addShareMark(*session_.document(), mark);
}

void JoinTool::finish() {
    last_.reset();
    if (session_.document()) {
        session_.document()->endMerge();
    }
    emit ended();
}

} // namespace dipwright
