// An invisible VTK window that draws into pictures on its own thread.
//
// It is created and destroyed on the UI thread and used on the thread given to start().
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

    // Returns whether an OpenGL 3.2 context could be created.
    bool isUsable() const { return !device_.isEmpty(); }
    const QString& device() const { return device_; } // the renderer's name

    // Call start() first and finish() last. Between these calls, the window belongs to `thread`.
    void start(QThread& thread); // call on the UI thread
    void finish();               // call on `thread`

    // Call these on `thread`.
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
