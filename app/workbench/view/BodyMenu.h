// What is done to the body by its menu and by keys: turned and moved by steps, a face laid down or
// marked as one that must be good. Each is one step to undo.
#pragma once

#include "workbench/actions/BodyStep.h"
#include "workbench/dip/DipSession.h"
#include "workbench/view/DipScene.h"

class QAction;
class QActionGroup;

namespace dipwright {

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
