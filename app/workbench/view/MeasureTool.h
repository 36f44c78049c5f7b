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

    void setActive(bool active); // begins anew
    void setLengthUnit(LengthUnit unit);
    // The marks stay on the body wherever it goes, and go with it: to be called when the body has
    // moved or is another one.
    void show();

private:
    void click(const ViewRay& ray);
    QString distance() const; // empty before the second place

    DipView& view_;
    const DipScene& scene_;
    Messages& messages_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    bool active_ = false;
    std::vector<Eigen::Vector3f> places_; // model coordinates
    std::shared_ptr<const TexturedMesh> model_;
};

} // namespace dipwright
