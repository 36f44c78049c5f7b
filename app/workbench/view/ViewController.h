// Controls camera and display of the 3D view by the window's actions.
#pragma once

#include "workbench/document/Preferences.h"
#include "workbench/jobs/Messages.h"
#include "workbench/view/DipScene.h"

class QWidget;

namespace dipwright {

class JobRunner;
class LookInsideBar;
class StretchPanel;
class WindowActions;

class ViewController : public QObject {
    Q_OBJECT

public:
    // `stretch` chooses the film's colours. `inside` sets the section and the opacity.
    ViewController(const WindowActions& actions, DipView& view, DipScene& scene,
                   LookInsideBar& inside, const StretchPanel& stretch, JobRunner& jobs,
                   Messages& messages, QWidget& window);

    void setPreferences(const Preferences& preferences);

private:
    void connectCamera(const WindowActions& actions);
    void connectDisplay(const WindowActions& actions);
    void connectInside(const WindowActions& actions);
    void showSection();
    void setFilmLook(FilmLook look);
    void showPicture(const QString& path);

    DipView& view_;
    DipScene& scene_;
    LookInsideBar& inside_;
    const StretchPanel& stretch_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    bool isCutOpen_ = false;
};

} // namespace dipwright
