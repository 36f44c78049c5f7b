#include "view/JoinTool.h"

#include "document/ShareEdits.h"

namespace dipwright {

JoinTool::JoinTool(DipView& view, const DipScene& scene, const DipSession& session, QObject* parent)
    : QObject(parent), scene_(scene), session_(session) {
    connect(&view, &DipView::clicked, this, &JoinTool::click);
}

void JoinTool::click(const ViewRay& ray) {
    const auto place = brush_ && session_.document() ? scene_.modelPoint(ray) : std::nullopt;
    if (!place) {
        return;
    }
    ShareMark mark = *brush_;
    for (int axis = 0; axis < 3; ++axis) {
        mark.place[std::size_t(axis)] = Millimetres(double((*place)[axis]));
    }
    addShareMark(*session_.document(), mark);
}

} // namespace dipwright
