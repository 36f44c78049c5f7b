#include "view/ZoneTool.h"

#include "document/ZoneEdits.h"

namespace dipwright {

ZoneTool::ZoneTool(DipView& view, const DipScene& scene, const DipSession& session, QObject* parent)
    : QObject(parent), scene_(scene), session_(session) {
    connect(&view, &DipView::clicked, this, &ZoneTool::click);
}

void ZoneTool::click(const ViewRay& ray) {
    const auto place = brush_ && session_.document() ? scene_.modelPoint(ray) : std::nullopt;
    if (!place) {
        return;
    }
    ZoneMark mark = *brush_;
    for (int axis = 0; axis < 3; ++axis) {
        mark.place[std::size_t(axis)] = Millimetres(double((*place)[axis]));
    }
    addZoneMark(*session_.document(), mark);
}

} // namespace dipwright
