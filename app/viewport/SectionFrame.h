// Draws the frame with which the user drags the section plane.
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

    void set(const std::optional<SectionPlane>& plane); // no plane: the frame is hidden
    void highlight(bool lit);
    void setColour(const QColor& colour);
    void setPixelRatio(double ratio); // screen pixels per window pixel

private:
    double pixelRatio_ = 1;
    bool lit_ = false;
    vtkSmartPointer<vtkPolyData> data_;
    vtkSmartPointer<vtkActor> actor_;
};

} // namespace dipwright
