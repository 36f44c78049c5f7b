#include "NavigationStyle.h"

#include "base/Units.h"

#include <algorithm>
#include <cmath>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace dipwright {

vtkStandardNewMacro(NavigationStyle);

namespace {

constexpr double degreesPerPixel = 0.4;

} // namespace

CameraAngles cameraAngles(vtkCamera& camera) {
    const Eigen::Vector3d from = -Eigen::Vector3d(camera.GetDirectionOfProjection());
    const Eigen::Vector3d up(camera.GetViewUp());
    // The picture's up direction and the direction to the camera span the vertical plane. If the
    // camera looks straight down, only the up direction gives the azimuth.
    const Eigen::Vector3d level = std::abs(from.y()) < 0.99 ? from
                                  : from.y() > 0            ? Eigen::Vector3d(-up)
                                                            : up;
    return {std::atan2(level.x(), level.z()) * 180 / pi,
            std::asin(std::clamp(from.y(), -1.0, 1.0)) * 180 / pi};
}

void setCameraAngles(vtkCamera& camera, CameraAngles angles) {
    const double azimuth = radians(Degrees(angles.azimuth));
    const double elevation = radians(Degrees(angles.elevation));
    const Eigen::Vector3d level(std::sin(azimuth), 0, std::cos(azimuth));
    const Eigen::Vector3d upright = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d from = std::cos(elevation) * level + std::sin(elevation) * upright;
    const Eigen::Vector3d up = std::cos(elevation) * upright - std::sin(elevation) * level;
    const Eigen::Vector3d position =
        Eigen::Vector3d(camera.GetFocalPoint()) + camera.GetDistance() * from;
    camera.SetPosition(position.data());
    camera.SetViewUp(up.data());
}

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
    const double right = rightPixels * degreesPerPixel, up = upPixels * degreesPerPixel;
    if (navigation_ == Navigation::Trackball) {
        camera->Azimuth(-right);
        camera->Elevation(-up);
        camera->OrthogonalizeViewUp();
    } else {
        const CameraAngles now = cameraAngles(*camera);
        setCameraAngles(*camera,
                        {now.azimuth - right, std::clamp(now.elevation - up, -90.0, 90.0)});
    }
    CurrentRenderer->ResetCameraClippingRange();
    CurrentRenderer->UpdateLightsGeometryToFollowCamera();
}

} // namespace dipwright
