// Turns the body by the rings and moves it by the arrows of the view. A drag is one undo step.
#pragma once

#include "dip/Pose.h"
#include "viewport/DipView.h"
#include "workbench/dip/DipSession.h"
#include "workbench/widgets/Units.h"

#include <optional>

namespace dipwright {

// Returns `immersion` with its body turned by `degrees` about the world's X, Y or Z axis. The
// angles are rounded to 0.1°.
Immersion turned(const Immersion& immersion, int axis, double degrees);

// Returns `immersion` turned so that the face with the normal `outward` (model coordinates) points
// down. Uses the smallest rotation. The angles are rounded to 0.1°.
Immersion withFaceDown(const Immersion& immersion, const Eigen::Vector3d& outward);

class BodyHandles : public QObject {
    Q_OBJECT

public:
    // Changes the immersion that the session shows. The arrows along X and Z change its offset. The
    // arrow along Y changes the depth of the dips, if the project has one.
    BodyHandles(const DipSession& session, const DipView& view, QObject* parent = nullptr);

    void setLengthUnit(LengthUnit unit) { unit_ = unit; }

signals:
    void held(bool isHeld);         // while a ring or an arrow is dragged
    void told(const QString& text); // says how far the body was dragged

private:
    void turn(int axis, double degrees);
    void move(int axis, double millimetres);
    void hold();
    void finish();

    const DipSession& session_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    std::optional<Immersion> before_;        // at the start of the drag
    std::optional<Millimetres> depthBefore_; // depth of the dips at the start of the drag
};

} // namespace dipwright
