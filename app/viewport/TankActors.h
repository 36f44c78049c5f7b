// Draws the water around the film and the edges of the tank.
#pragma once

#include "DipView.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

class TankActors {
public:
    explicit TankActors(vtkRenderer* renderer);

    // Returns the width, in mm, of the water around a film of this size.
    static double margin(QSizeF film);

    void setSize(QSizeF film, double depth);
    void setVisible(bool visible);
    void setColours(const QColor& water, const QColor& edge);
    void setPixelRatio(double ratio); // screen pixels per window pixel

private:
    vtkSmartPointer<vtkPolyData> waterData_, edgeData_;
    vtkSmartPointer<vtkActor> water_, edge_;
};

} // namespace dipwright
