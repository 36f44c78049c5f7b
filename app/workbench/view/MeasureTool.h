// Measures the distance between two places of the body that the user clicks.
#pragma once

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
    void click(const ViewRay& ray);
    QString distance() const; // empty until there are two places

    DipView& view_;
    const DipScene& scene_;
    Messages& messages_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    bool active_ = false;
    std::vector<Eigen::Vector3f> places_; // model coordinates
    std::shared_ptr<const TexturedMesh> model_;
};

} // namespace dipwright
