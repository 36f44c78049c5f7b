// Marks on the body for the join of two dips, where the user clicks or drags.
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

signals:
    void begun(); // a stroke, which is one step to undo
    void ended();

private:
    bool begins(const ViewRay& ray);
    void stroke(const ViewRay& ray);
    void finish();

    const DipScene& scene_;
    const DipSession& session_;
    std::optional<ShareMark> brush_;
    std::optional<Eigen::Vector3f> last_; // of the stroke's marks
};

} // namespace dipwright
