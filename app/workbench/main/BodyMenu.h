// What is done to the body by its menu and by keys: turned and moved by steps, a face laid down or
// marked as one that must be good. Each is one step to undo.
#pragma once

#include "session/DipSession.h"
#include "view/DipScene.h"

class QAction;
class QActionGroup;

namespace dipwright {

// In an action's data: an axis of the world, and which way, as +1 or −1 step of the view's handles;
// of moves 0 as way is to the film's middle. X and Z are along the film.
struct BodyStep {
    int axis = 0, way = 0;
};

class BodyMenu : public QObject {
    Q_OBJECT

public:
    // For the immersion that the session looks at. The menu of `view` has what is done to the face
    // under the cursor, and the actions of both groups, whose data are BodySteps.
    BodyMenu(DipView& view, const DipScene& scene, const DipSession& session, QActionGroup& turns,
             QActionGroup& moves, QObject* parent = nullptr);

private:
    void show(const ViewRay& ray, const QPoint& place);
    void edit(const QString& text, const std::function<void(Immersion&)>& change);
    void turn(const QAction& action);
    void move(const QAction& action);
    void layDown(std::uint32_t triangle);
    void markGood(const SurfacePoint& place);

    DipView& view_;
    const DipScene& scene_;
    const DipSession& session_;
    QActionGroup &turns_, &moves_;
};

} // namespace dipwright

Q_DECLARE_METATYPE(dipwright::BodyStep)
