// Camera and display of the 3D view, by their actions.
#pragma once

#include "session/Messages.h"
#include "view/DipScene.h"

class QWidget;

namespace dipwright {

class JobRunner;
class StretchPanel;
class WindowActions;

class ViewController : public QObject {
    Q_OBJECT

public:
    // The film wears its stretch as `stretch` shows it.
    ViewController(const WindowActions& actions, DipView& view, DipScene& scene,
                   const StretchPanel& stretch, JobRunner& jobs, Messages& messages,
                   QWidget& window);

private:
    void connectCamera(const WindowActions& actions);
    void connectDisplay(const WindowActions& actions);
    void setFilmLook(FilmLook look);
    void wearPicture(const QString& path);

    DipView& view_;
    DipScene& scene_;
    const StretchPanel& stretch_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
};

} // namespace dipwright
