// How the mouse moves the camera: left turns, middle or right or Shift shifts, the wheel zooms.
#pragma once

#include "DipView.h"

#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>

namespace dipwright {

// Where a camera looks from, in degrees: azimuth 0 is the front (+Z), 90 the right (+X); elevation
// 90 is straight above. Above and below, the azimuth says which way is up in the picture.
struct CameraAngles {
    double azimuth = 0, elevation = 0;
};
CameraAngles cameraAngles(vtkCamera& camera);
// Keeps focal point and distance; up stays up.
void setCameraAngles(vtkCamera& camera, CameraAngles angles);

class NavigationStyle : public vtkInteractorStyleTrackballCamera {
public:
    static NavigationStyle* New();

    void setNavigation(Navigation navigation) { navigation_ = navigation; }
    // Turns the camera by pixels as a drag would.
    void turn(double rightPixels, double upPixels);

    void OnRightButtonDown() override { OnMiddleButtonDown(); }
    void OnRightButtonUp() override { OnMiddleButtonUp(); }
    // VTK's single-key shortcuts would fight with the program's own.
    void OnChar() override {}
    void OnKeyPress() override {}
    void Rotate() override;

private:
    Navigation navigation_ = Navigation::Turntable;
};

} // namespace dipwright
