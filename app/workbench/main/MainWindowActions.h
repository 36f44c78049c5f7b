// The actions of a window, by name; private to MainWindow.
#pragma once

#include "main/MainWindow.h"

class QAction;

namespace dipwright {

struct MainWindow::Actions {
    QAction *newWindow, *newProject, *open, *save, *saveAs, *exportResults, *exportPdf, *exportPng,
        *print, *calibrate, *profiles, *close, *quit;
    QAction *undo, *redo, *addImmersion, *removeImmersion, *preferences;
    QAction *run, *cancel, *live, *certainty, *resetLayout, *saveLayout;
    QAction *fit, *oblique, *front, *back, *left, *right, *top, *bottom, *parallel;
    QAction *rings, *water, *body, *coverage, *measure, *filmOnBody;
    QAction *reloadModel, *replaceModel, *replaceTexture;
    QAction *play, *tour, *guide, *whatsThis, *about;
    QActionGroup* filmLook;
};

} // namespace dipwright
