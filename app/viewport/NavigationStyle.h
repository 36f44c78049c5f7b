// Moves the camera with the mouse. The left button turns the view. The middle button, the right
// button, or Shift with the left button shifts it. The wheel zooms.
#pragma once

#include "DipView.h"

#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>

namespace dipwright {

// The direction from which a camera looks, in degrees. Azimuth 0 is the front (+Z), 90 the right
// (+X). Elevation 90 is straight above. Straight above or below, the azimuth defines the picture's
// up direction.
struct CameraAngles {
    double azimuth = 0, elevation = 0;
};
CameraAngles cameraAngles(vtkCamera& camera);
// Sets the camera's direction. Keeps its focal point and distance; vertical lines stay vertical.
void setCameraAngles(vtkCamera& camera, CameraAngles angles);

class NavigationStyle : public vtkInteractorStyleTrackballCamera {
public:
    static NavigationStyle* New();

    void setNavigation(Navigation navigation) { navigation_ = navigation; }
    // Turns the camera like a drag by these numbers of pixels.
    void turn(double rightPixels, double upPixels);

    void OnRightButtonDown() override { OnMiddleButtonDown(); }
    void OnRightButtonUp() override { OnMiddleButtonUp(); }
    // Disables VTK's single-key shortcuts, which would conflict with the program's own.
    void OnChar() override {}
    void OnKeyPress() override {}
    void Rotate() override;

private:
    Navigation navigation_ = Navigation::Turntable;
};

} // namespace dipwright
