#include "PictureWindow.h"

#include <QCoreApplication>
#include <QOpenGLFunctions>
#include <QThread>
#include <vtkCommand.h>
#include <vtkUnsignedCharArray.h>

namespace dipwright {

namespace {

QSurfaceFormat pictureFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

} // namespace

PictureWindow::PictureWindow() {
    context_.setFormat(pictureFormat());
    surface_.setFormat(context_.format());
    surface_.create();
    if (!context_.create() || !surface_.isValid() || !context_.makeCurrent(&surface_)) {
        return;
    }
    const GLubyte* name = context_.functions()->glGetString(GL_RENDERER);
    device_ = QString::fromUtf8(reinterpret_cast<const char*>(name));
    context_.doneCurrent();
}

void PictureWindow::start(QThread& thread) {
    context_.moveToThread(&thread);
}

void PictureWindow::open() {
    for (const auto event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                             vtkCommand::WindowSupportsOpenGLEvent}) {
        window_->AddObserver(event, this, &PictureWindow::answer);
    }
    context_.makeCurrent(&surface_);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetForceMaximumHardwareLineWidth(1);
    window_->SetMultiSamples(0);
    window_->SetReadyForRendering(true);
    window_->SetOwnContext(0);
    window_->OpenGLInitContext();
}

void PictureWindow::finish() {
    window_->Finalize();
    window_->SetReadyForRendering(false);
    window_->RemoveAllObservers();
    context_.doneCurrent();
    context_.moveToThread(QCoreApplication::instance()->thread());
}

void PictureWindow::answer(vtkObject* /*caller*/, unsigned long event, void* data) {
    if (event == vtkCommand::WindowMakeCurrentEvent) {
        context_.makeCurrent(&surface_);
    } else if (event == vtkCommand::WindowIsCurrentEvent) {
        *static_cast<bool*>(data) = QOpenGLContext::currentContext() == &context_;
    } else {
        *static_cast<int*>(data) = 1;
    }
}

QImage PictureWindow::draw() {
    window_->Render();
    const int width = window_->GetSize()[0], height = window_->GetSize()[1];
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 1, pixels);
    return QImage(pixels->GetPointer(0), width, height, QImage::Format_RGBX8888)
        .mirrored()
        .convertToFormat(QImage::Format_RGB32);
}

} // namespace dipwright
