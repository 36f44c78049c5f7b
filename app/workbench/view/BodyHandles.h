// The body turned by its rings: a drag is one step to undo.
#pragma once

#include "dip/Pose.h"
#include "session/DipSession.h"
#include "viewport/DipView.h"

#include <optional>

namespace dipwright {

// `immersion` with its body turned further by so many degrees about the world's X, Y or Z, its
// angles rounded to tenths.
Immersion turned(const Immersion& immersion, int axis, double degrees);

// `immersion` with a face down, `outward` (model coordinates) its normal: turned no farther than it
// must be, its angles rounded to tenths.
Immersion laidDown(const Immersion& immersion, const Eigen::Vector3d& outward);

class BodyTurn : public QObject {
    Q_OBJECT

public:
    // Turns the body of the immersion that the session looks at.
    BodyTurn(const DipSession& session, const DipView& view, QObject* parent = nullptr);

signals:
    void held(bool isHeld); // as long as a ring is dragged

private:
    void drag(int axis, double degrees);
    void finish();

    const DipSession& session_;
    std::optional<Immersion> before_; // as it was when the drag began
};

} // namespace dipwright
