// Turns the body by the rings and moves it by the arrows of the view. A drag is one undo step.
#pragma once

#include "viewport/DipView.h"
#include "workbench/dip/DipSession.h"
#include "workbench/document/PoseEdits.h"
#include "workbench/view/DipScene.h"
#include "workbench/widgets/Units.h"

#include <optional>

namespace dipwright {

class BodyHandles : public QObject {
    Q_OBJECT

public:
    // Changes the immersion that the session shows. The arrows along X and Z change its offset. The
    // arrow along Y changes the depth of the dips, if the project has one. If the scene shows a
    // pose of a path, rings and arrows change that pose.
    BodyHandles(const DipSession& session, const DipView& view, const DipScene& scene,
                QObject* parent = nullptr);

    void setLengthUnit(LengthUnit unit) { unit_ = unit; }

signals:
    void held(bool isHeld);         // while a ring or an arrow is dragged
    void told(const QString& text); // says how far the body was dragged

private:
    void turn(int axis, double degrees);
    void move(int axis, double millimetres);
    void moveDown(double millimetres);
    void hold();
    void finish();

    const DipSession& session_;
    const DipScene& scene_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    std::optional<Immersion> before_;        // at the start of the drag
    ShownPose shownBefore_;                  // at the start of the drag
    std::optional<Millimetres> depthBefore_; // depth of the dips at the start of the drag
};

} // namespace dipwright
