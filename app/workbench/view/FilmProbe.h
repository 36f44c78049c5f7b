// Reads values from the film under the cursor, in the view and in the results, and describes them.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/view/DipScene.h"
#include "workbench/widgets/Units.h"

namespace dipwright {

class ResultsPanel;

class FilmProbe : public QObject {
    Q_OBJECT

public:
    FilmProbe(const DipSession& session, DipView& view, const DipScene& scene,
              ResultsPanel& results, QObject* parent = nullptr);

    void setLengthUnit(LengthUnit unit) { unit_ = unit; }
    // Points the camera at the place on the body where the film point with the rest position `rest`
    // lies. Reads the film there. The view must show the end of the dip.
    void lookAtFilmPlace(const Eigen::Vector2f& rest);

signals:
    void read(const QString& description); // empty: nothing under the cursor

private:
    void readAlong(const ViewRay& ray);
    void show(const std::optional<FilmReadoutPoint>& point);
    QString describe(const FilmReadoutPoint& point) const;
    QString describeBody(const Eigen::Vector3f& place) const;

    const DipSession& session_;
    DipView& view_;
    const DipScene& scene_;
    ResultsPanel& results_;
    LengthUnit unit_ = LengthUnit::Millimetre;
};

} // namespace dipwright
