// The frame of the plane that cuts body and film open, by which it is dragged.
#pragma once

#include "SectionPlane.h"

#include <QColor>
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

class SectionFrame {
public:
    explicit SectionFrame(vtkRenderer* renderer);

    void set(const std::optional<SectionPlane>& plane); // none: hidden
    void highlight(bool lit);
    void setColour(const QColor& colour);
    void setPixelRatio(double ratio); // pixels of the screen to one of the window

private:
    double pixelRatio_ = 1;
    bool lit_ = false;
    vtkSmartPointer<vtkPolyData> data_;
    vtkSmartPointer<vtkActor> actor_;
};

} // namespace dipwright
