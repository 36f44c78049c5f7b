// A window of VTK's that nobody sees: it draws into pictures, on a thread of its own.
//
// Made and destroyed on the UI thread, used on the thread given to start().
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

class QThread;

namespace dipwright {

class PictureWindow {
public:
    PictureWindow();

    // False where no OpenGL 3.2 context could be made.
    bool isUsable() const { return !device_.isEmpty(); }
    const QString& device() const { return device_; } // the renderer's name

    // The first and the last call; between them the window belongs to `thread`.
    void start(QThread& thread); // UI thread
    void finish();               // `thread`

    // On `thread`.
    void open();
    vtkGenericOpenGLRenderWindow* vtk() { return window_; }
    QImage draw();

private:
    void answer(vtkObject* caller, unsigned long event, void* data);

    QOffscreenSurface surface_;
    QOpenGLContext context_;
    QString device_;
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
};

} // namespace dipwright
