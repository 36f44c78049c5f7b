// The body turned by its rings and moved by its arrows: a drag is one step to undo.
#pragma once

#include "dip/Pose.h"
#include "viewport/DipView.h"
#include "workbench/dip/DipSession.h"
#include "workbench/widgets/Units.h"

#include <optional>

namespace dipwright {

// `immersion` with its body turned further by so many degrees about the world's X, Y or Z, its
// angles rounded to tenths.
Immersion turned(const Immersion& immersion, int axis, double degrees);

// `immersion` with a face down, `outward` (model coordinates) its normal: turned no farther than it
// must be, its angles rounded to tenths.
Immersion laidDown(const Immersion& immersion, const Eigen::Vector3d& outward);

class BodyHandles : public QObject {
    Q_OBJECT

public:
    // For the immersion that the session looks at. Along X and Z its offset is moved, along Y the
    // depth of the dips, where the project has one.
    BodyHandles(const DipSession& session, const DipView& view, QObject* parent = nullptr);

    void setLengthUnit(LengthUnit unit) { unit_ = unit; }

signals:
    void held(bool isHeld);         // as long as a ring or an arrow is dragged
    void told(const QString& text); // how far it has been dragged

private:
    void turn(int axis, double degrees);
    void move(int axis, double millimetres);
    void hold();
    void finish();

    const DipSession& session_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    // As they were when the drag began.
    std::optional<Immersion> before_;
    std::optional<Millimetres> depthBefore_;
};

} // namespace dipwright
