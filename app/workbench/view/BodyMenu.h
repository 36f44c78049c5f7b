// Edits the body from its context menu and by keys: turn and move it by steps, lay a face down, or
// mark a face as zone A or as a mask. Each edit is one undo step.
#pragma once

#include "workbench/actions/BodyStep.h"
#include "workbench/dip/DipSession.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/view/DipScene.h"

class QAction;
class QActionGroup;

namespace dipwright {

class BodyMenu : public QObject {
    Q_OBJECT

public:
    // Changes the immersion that the session shows. The context menu of `view` edits the face under
    // the cursor and contains the actions of both groups. The actions' data are BodySteps.
    BodyMenu(DipView& view, const DipScene& scene, const DipSession& session, QActionGroup& turns,
             QActionGroup& moves, QObject* parent = nullptr);

signals:
    void refused(const QString& sentence); // the project cannot hold the mark

private:
    void show(const ViewRay& ray, const QPoint& place);
    void edit(const QString& text, const std::function<void(Immersion&)>& change);
    void turn(const QAction& action);
    void move(const QAction& action);
    void layDown(std::uint32_t triangle);
    void markFace(const SurfacePoint& place, const MarkBrush& brush);

    DipView& view_;
    const DipScene& scene_;
    const DipSession& session_;
    QActionGroup &turns_, &moves_;
};

} // namespace dipwright
