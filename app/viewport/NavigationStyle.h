// Moves the camera with the mouse. Left turns; middle, right or Shift with left shifts; the wheel
// zooms.
#pragma once

#include "DipView.h"

#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>

namespace dipwright {

// The direction that a camera looks from, in degrees. Azimuth 0 is the front (+Z), 90 the right
// (+X). Elevation 90 is straight above. Straight above or below, the azimuth defines the picture's
// up direction.
struct CameraAngles {
    double azimuth = 0, elevation = 0;
};
CameraAngles cameraAngles(vtkCamera& camera);
// Keeps focal point and distance; the vertical stays vertical.
void setCameraAngles(vtkCamera& camera, CameraAngles angles);

class NavigationStyle : public vtkInteractorStyleTrackballCamera {
public:
    static NavigationStyle* New();

    void setNavigation(Navigation navigation) { navigation_ = navigation; }
    // Turns the camera as a drag by these pixels would.
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
