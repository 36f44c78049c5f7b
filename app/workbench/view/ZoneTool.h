// Marks zones on the body, where the user clicks.
#pragma once

#include "session/DipSession.h"
#include "view/DipScene.h"

namespace dipwright {

class ZoneTool : public QObject {
    Q_OBJECT

public:
    ZoneTool(DipView& view, const DipScene& scene, const DipSession& session,
             QObject* parent = nullptr);

    // The mark of a click, without its place; none: clicks are somebody else's.
    void setBrush(const std::optional<ZoneMark>& brush) { brush_ = brush; }

private:
    void click(const ViewRay& ray);

    const DipScene& scene_;
    const DipSession& session_;
    std::optional<ZoneMark> brush_;
};

} // namespace dipwright
