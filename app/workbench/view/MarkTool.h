// Sets marks on the body where the user clicks or drags, for the seam of two dips or for zones.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/view/DipScene.h"

namespace dipwright {

class MarkTool : public QObject {
    Q_OBJECT

public:
    MarkTool(DipView& view, const DipScene& scene, const DipSession& session,
             QObject* parent = nullptr);

    // Without a brush, the tool ignores presses on the body.
    void setBrush(const MarkBrush& brush) { brush_ = brush; }

signals:
    void begun(); // a stroke; it is one undo step
    void ended();

private:
    bool begins(const ViewRay& ray);
    void stroke(const ViewRay& ray);
    void finish();

    const DipScene& scene_;
    const DipSession& session_;
    MarkBrush brush_;
    std::optional<Eigen::Vector3f> last_; // place of the stroke's last mark
};

} // namespace dipwright
