// How the mouse moves the camera: left turns, middle or right or Shift shifts, the wheel zooms.
#pragma once

#include "DipView.h"

#include <vtkInteractorStyleTrackballCamera.h>

namespace dipwright {

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
