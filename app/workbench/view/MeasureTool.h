// Measures between two places of the body that the user clicks: the straight distance, and the
// length of a short line along the surface (geometry/SurfacePath.h).
#pragma once

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"
#include "workbench/view/DipScene.h"
#include "workbench/widgets/Units.h"

namespace dipwright {

class MeasureTool : public QObject {
    Q_OBJECT

public:
    MeasureTool(DipView& view, const DipScene& scene, Messages& messages,
                QObject* parent = nullptr);

    void setActive(bool active); // starts a new measurement
    void setLengthUnit(LengthUnit unit);
    // Updates the marks, which move with the body. Call this when the body has moved or was
    // replaced.
    void show();

private:
    using Line = std::vector<Eigen::Vector3f>; // model coordinates
    void click(const ViewRay& ray);
    void clear();
    void findLine();
    void takeLine(const Line& line);
    QString distance() const; // empty until there are two places

    DipView& view_;
    const DipScene& scene_;
    Messages& messages_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    bool active_ = false;
    std::vector<SurfacePoint> places_;
    Line line_; // along the surface; empty: not known
    std::shared_ptr<const TexturedMesh> model_;
    CancelToken search_; // of the line
    JobRunner jobs_;     // its own, so that the line does not wait for a dip
};

} // namespace dipwright
