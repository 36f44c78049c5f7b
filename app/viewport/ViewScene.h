// Holds everything that VTK draws of a dip, with camera and mouse. It lives on the view's drawing
// thread; no other thread may use it.
#pragma once

#include "BodyActors.h"
#include "CradleActor.h"
#include "FilmActor.h"
#include "MarkerActors.h"
#include "MoveArrows.h"
#include "NavigationStyle.h"
#include "PictureWindow.h"
#include "RotationRings.h"
#include "SectionFrame.h"
#include "TankActors.h"

#include <vtkCameraOrientationWidget.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkOpenGLRenderer.h>

namespace dipwright {

// A picture, with its projection and its camera.
struct ViewPicture {
    QImage image;
    ViewProjection projection;
    ViewCamera camera;
    bool isMovedByUser = false; // the camera was last moved here, not by setCamera()
};

// The size of the widget that shows the pictures.
struct ViewSize {
    QSize size{1, 1};
    double pixelRatio = 1; // screen pixels per window pixel
    double fontSize = 10;  // points
};

// What the camera shows as large as possible: body and film, the body with its rings and arrows, or
// the body alone.
enum class FittedPlaces { Film, Handles, Body };

enum class MouseAction { Press, Release, Move };

struct ViewMouse {
    MouseAction action = MouseAction::Move;
    Qt::MouseButton button = Qt::NoButton;
    QPointF position; // widget coordinates
    Qt::KeyboardModifiers modifiers;
};

class ViewScene {
public:
    // `pictureAsked` is called when the mouse has changed the scene.
    ViewScene(PictureWindow& window, const std::function<void()>& pictureAsked);
    ~ViewScene();

    BodyActors& body() { return body_; }
    FilmActor& film() { return film_; }
    TankActors& tank() { return tank_; }
    RingActors& rings() { return rings_; }
    ArrowActors& arrows() { return arrows_; }
    CradleActor& cradle() { return cradle_; }
    MarkerActors& markers() { return markers_; }
    SectionFrame& sectionFrame() { return frame_; }
    NavigationStyle& style() { return *style_; }
    vtkCamera& camera() { return *renderer_->GetActiveCamera(); }

    void setSize(const ViewSize& size);
    void setFilmSize(QSizeF film, double tankDepth);
    void setFilmFitted(bool fitted);
    void setSection(const std::optional<SectionPlane>& section); // no section: nothing is cut open
    void setColours(const ViewColours& colours);
    void look(ViewDirection direction); // fits the view as the last fit did
    // Points the camera at a place from outside, close to the body but with a large part of it
    // visible.
    void lookAt(const Eigen::Vector3f& place, const Eigen::Vector3f& outward);
    void fit(FittedPlaces places);
    void turn(double rightPixels, double upPixels); // like a drag by these numbers of pixels
    void fly(const PuckMotion& motion);
    void zoom(double factor); // keeps the centre in place
    // Keeps the surface point that is shown at the widget position `place` there.
    void zoomAt(const QPointF& place, double factor);
    void mouse(const ViewMouse& mouse);
    void setCamera(const ViewCamera& camera);
    ViewPicture draw();

private:
    ViewCamera cameraNow();
    void fitCamera();

    PictureWindow& window_;
    vtkNew<vtkOpenGLRenderer> renderer_;
    vtkNew<NavigationStyle> style_;
    vtkNew<vtkGenericRenderWindowInteractor> interactor_;
    vtkNew<vtkCameraOrientationWidget> orientation_;
    BodyActors body_{renderer_};
    FilmActor film_{renderer_};
    CradleActor cradle_{renderer_};
    TankActors tank_{renderer_};
    RingActors rings_{renderer_};
    ArrowActors arrows_{renderer_};
    MarkerActors markers_{renderer_};
    SectionFrame frame_{renderer_};
    ViewSize size_;
    QSizeF filmSize_{210, 297};
    std::function<void()> pictureRequested_;
    bool fitsFilm_ = true;
    FittedPlaces fits_ = FittedPlaces::Film;
    bool fitted_ = false;  // the camera was placed by fit() or look()
    bool resized_ = false; // the size has changed since the last picture
    bool isMovedByUser_ = true;
};

} // namespace dipwright
