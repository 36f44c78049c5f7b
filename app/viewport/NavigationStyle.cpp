#include "NavigationStyle.h"

#include <algorithm>
#include <cmath>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace dipwright {

vtkStandardNewMacro(NavigationStyle);

namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double steepest =
    89.5; // looking straight down the axis would leave the turntable undefined

} // namespace

void NavigationStyle::Rotate() {
    if (navigation_ == Navigation::Trackball) {
        vtkInteractorStyleTrackballCamera::Rotate();
        return;
    }
    const int* now = Interactor->GetEventPosition();
    const int* before = Interactor->GetLastEventPosition();
    turn(now[0] - before[0], now[1] - before[1]);
    Interactor->Render();
}

void NavigationStyle::turn(double rightPixels, double upPixels) {
    if (!CurrentRenderer) {
        return;
    }
    vtkCamera* camera = CurrentRenderer->GetActiveCamera();
    camera->Azimuth(-rightPixels * degreesPerPixel);
    if (navigation_ == Navigation::Trackball) {
        camera->Elevation(-upPixels * degreesPerPixel);
        camera->OrthogonalizeViewUp();
    } else {
        const double* direction = camera->GetDirectionOfProjection();
        const double height = std::asin(std::clamp(-direction[1], -1.0, 1.0)) * 180 / vtkMath::Pi();
        const double target = std::clamp(height - upPixels * degreesPerPixel, -steepest, steepest);
        camera->SetViewUp(0, 1, 0);
        camera->Elevation(target - height);
        camera->SetViewUp(0, 1, 0);
    }
    CurrentRenderer->ResetCameraClippingRange();
    CurrentRenderer->UpdateLightsGeometryToFollowCamera();
}

} // namespace dipwright
