// Marks on the body for the join of two dips, where the user clicks.
#pragma once

#include "session/DipSession.h"
#include "view/DipScene.h"

namespace dipwright {

class JoinTool : public QObject {
    Q_OBJECT

public:
    JoinTool(DipView& view, const DipScene& scene, const DipSession& session,
             QObject* parent = nullptr);

    // The mark of a click, without its place; none: clicks are somebody else's.
    void setBrush(const std::optional<ShareMark>& brush) { brush_ = brush; }

private:
    void click(const ViewRay& ray);

    const DipScene& scene_;
    const DipSession& session_;
    std::optional<ShareMark> brush_;
};

} // namespace dipwright
