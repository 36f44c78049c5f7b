#include "ViewScene.h"

#include "SpaceMouse.h"
#include "VtkConversions.h"
#include "base/Units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCameraOrientationRepresentation.h>

namespace dipwright {

namespace {

// Moves the camera without rotation, so that all places are centred and drawn as large as possible.
void fitCamera(vtkCamera& camera, const std::vector<Eigen::Vector3d>& places, double aspect) {
    constexpr double room = 1.06; // a margin of 3 % on each side of the places
    const Eigen::Vector3d view = Eigen::Vector3d(camera.GetDirectionOfProjection()).normalized();
    const Eigen::Vector3d right = view.cross(Eigen::Vector3d(camera.GetViewUp())).normalized();
    const Eigen::Vector3d up = right.cross(view);
    const double down = std::tan(radians(Degrees(camera.GetViewAngle())) / 2) / room;
    const bool parallel = camera.GetParallelProjection() != 0;
    // Returns values along one axis of the picture: the centre, and the camera's distance from it
    // at which no place is beyond an edge. In parallel projection, the second value is half of the
    // visible size.
    const auto fitAlong = [&](const Eigen::Vector3d& axis, double slope) {
        double after = -std::numeric_limits<double>::infinity(), before = after;
        for (const Eigen::Vector3d& place : places) {
            const double nearer = parallel ? 0 : slope * place.dot(view);
            after = std::max(after, place.dot(axis) - nearer);
            before = std::max(before, -place.dot(axis) - nearer);
        }
        return std::pair((after - before) / 2, (after + before) / 2);
    };
    const auto [middleX, reachX] = fitAlong(right, down * aspect);
    const auto [middleY, reachY] = fitAlong(up, down);
    const double half = std::max(reachX / aspect, reachY);
    camera.SetParallelScale(half * room);
    const double distance = std::max(reachX / (down * aspect), reachY / down);
    const Eigen::Vector3d middle = middleX * right + middleY * up;
    const Eigen::Vector3d place = middle - distance * view;
    camera.SetFocalPoint(middle.x(), middle.y(), middle.z());
    camera.SetPosition(place.x(), place.y(), place.z());
}

ViewProjection projectionOf(vtkRenderer& renderer, QSizeF size) {
    const vtkMatrix4x4* matrix = renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), -1, 1);
    return {Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix->GetData()),
            size};
}

unsigned long eventOf(const ViewMouse& mouse) {
    switch (mouse.action) {
    case MouseAction::Move:
        return vtkCommand::MouseMoveEvent;
    case MouseAction::Press:
        return mouse.button == Qt::LeftButton     ? vtkCommand::LeftButtonPressEvent
               : mouse.button == Qt::MiddleButton ? vtkCommand::MiddleButtonPressEvent
                                                  : vtkCommand::RightButtonPressEvent;
    case MouseAction::Release:
        break;
    }
    return mouse.button == Qt::LeftButton     ? vtkCommand::LeftButtonReleaseEvent
           : mouse.button == Qt::MiddleButton ? vtkCommand::MiddleButtonReleaseEvent
                                              : vtkCommand::RightButtonReleaseEvent;
}

} // namespace

ViewScene::ViewScene(PictureWindow& window, const std::function<void()>& pictureAsked)
    : window_(window), pictureRequested_(pictureAsked) {
    window_.open();
    window_.vtk()->AddRenderer(renderer_);
    renderer_->UseFXAAOn(); // smooth edges at low cost, also without a GPU
    renderer_->GradientBackgroundOn();
    style_->SetDefaultRenderer(renderer_);
    style_->SetCurrentRenderer(renderer_);
    interactor_->SetRenderWindow(window_.vtk());
    interactor_->SetInteractorStyle(style_);
    interactor_->EnableRenderOff(); // pictures are drawn on request only
    interactor_->Initialize();
    vtkNew<vtkCallbackCommand> asked;
    asked->SetClientData(this);
    asked->SetCallback([](vtkObject*, unsigned long, void* scene, void*) {
        static_cast<ViewScene*>(scene)->pictureRequested_();
    });
    interactor_->AddObserver(vtkCommand::RenderEvent, asked);
    orientation_->SetParentRenderer(renderer_);
    orientation_->SetAnimate(false); // its animation would keep drawing pictures
    orientation_->On();
    markers_.setSize(std::hypot(filmSize_.width(), filmSize_.height()));
    look(ViewDirection::Oblique);
}

ViewScene::~ViewScene() {
    orientation_->Off();
    window_.finish();
}

void ViewScene::setSize(const ViewSize& size) {
    size_ = size;
    const double ratio = size.pixelRatio;
    const QSize pixels = size.size * ratio;
    interactor_->UpdateSize(pixels.width(), pixels.height());
    window_.vtk()->SetScreenSize(pixels.width(), pixels.height());
    window_.vtk()->SetDPI(int(72 * ratio));
    markers_.setFontSize(int(size.fontSize * 1.6 * ratio));
    rings_.setPixelRatio(ratio);
    tank_.setPixelRatio(ratio);
    body_.setPixelRatio(ratio);
    film_.setPixelRatio(ratio);
    frame_.setPixelRatio(ratio);
    markers_.setPixelRatio(ratio);
    auto* axes =
        vtkCameraOrientationRepresentation::SafeDownCast(orientation_->GetRepresentation());
    axes->SetSize(int(84 * ratio), int(84 * ratio));
    axes->SetPadding(int(14 * ratio), int(14 * ratio));
    resized_ = true;
    if (fitted_) {
        fitCamera();
    }
}

void ViewScene::setFilmSize(QSizeF film, double tankDepth) {
    filmSize_ = film;
    tank_.setSize(film, tankDepth);
    markers_.setSize(std::hypot(film.width(), film.height()));
}

void ViewScene::setSection(const std::optional<SectionPlane>& section) {
    vtkSmartPointer<vtkPlane> kept; // the normal points to the drawn side
    if (section) {
        kept = vtkSmartPointer<vtkPlane>::New();
        const Eigen::Vector3d normal = section->inward().cast<double>();
        const Eigen::Vector3d origin = section->place * Eigen::Vector3d::Unit(section->axis);
        kept->SetNormal(normal.data());
        kept->SetOrigin(origin.x(), origin.y(), origin.z());
    }
    body_.setSection(section, kept);
    film_.setSection(section, kept);
    frame_.set(section);
}

void ViewScene::setColours(const ViewColours& colours) {
    renderer_->SetBackground(vtkColour(colours.bottom).data());
    renderer_->SetBackground2(vtkColour(colours.top).data());
    tank_.setColours(colours.water, colours.ink);
    body_.setLineColours(colours.accent, colours.ink);
    film_.setCutColour(colours.accent);
    frame_.setColour(colours.accent);
    markers_.setColours(colours.accent, colours.ink);
}

void ViewScene::look(ViewDirection direction) {
    const CameraAngles angles = [direction]() -> CameraAngles {
        switch (direction) {
        case ViewDirection::Front:
            return {0, 0};
        case ViewDirection::Back:
            return {180, 0};
        case ViewDirection::Left:
            return {-90, 0};
        case ViewDirection::Right:
            return {90, 0};
        case ViewDirection::Top:
            return {0, 90};
        case ViewDirection::Bottom:
            return {0, -90};
        case ViewDirection::Oblique:
            break;
        }
        return {30, 28};
    }();
    setCameraAngles(camera(), angles);
    fitCamera();
}

void ViewScene::lookAt(const Eigen::Vector3f& place, const Eigen::Vector3f& outward) {
    constexpr double distance = 1.3, half = 0.35; // both as shares of the body's size
    constexpr double steepest = 85;               // degrees; the azimuth is undefined at 90°
    const double size = double(body_.worldBox().diagonal().norm());
    const double elevation =
        std::asin(std::clamp(double(outward.normalized().y()), -1.0, 1.0)) * 180 / pi;
    const bool isLevel = std::abs(elevation) < steepest;
    const double azimuth = isLevel ? std::atan2(double(outward.x()), double(outward.z())) * 180 / pi
                                   : cameraAngles(camera()).azimuth;
    const Eigen::Vector3d focus = place.cast<double>();
    camera().SetFocalPoint(focus.x(), focus.y(), focus.z());
    camera().SetPosition(focus.x(), focus.y(), focus.z() + distance * size);
    camera().SetParallelScale(half * size);
    setCameraAngles(camera(), {azimuth, std::clamp(elevation, -steepest, steepest)});
    renderer_->ResetCameraClippingRange();
    fitted_ = false;
    isMovedByUser_ = true;
}

void ViewScene::fit(FittedPlaces places) {
    fits_ = places;
    fitCamera();
}

void ViewScene::fitCamera() {
    const double margin = 2 * TankActors::margin(filmSize_);
    const Eigen::Vector3f half(float(filmSize_.width() + margin) / 2, 1,
                               float(filmSize_.height() + margin) / 2);
    std::vector<Eigen::Vector3d> places;
    const BoundingBox body = body_.worldBox();
    const bool hasFilm = (fitsFilm_ && fits_ == FittedPlaces::Film) || body.isEmpty();
    for (const BoundingBox& box : {body, hasFilm ? BoundingBox(-half, half) : BoundingBox()}) {
        for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
            places.emplace_back(box.corner(BoundingBox::CornerType(corner)).cast<double>());
        }
    }
    if (fits_ == FittedPlaces::Handles) {
        rings_.addPlaces(places);
        arrows_.addPlaces(places);
    }
    const double aspect =
        double(std::max(1, size_.size.width())) / std::max(1, size_.size.height());
    dipwright::fitCamera(camera(), places, aspect);
    renderer_->ResetCameraClippingRange();
    fitted_ = true;
    isMovedByUser_ = true;
}

void ViewScene::setFilmFitted(bool fitted) {
    fitsFilm_ = fitted;
    if (fitted_) {
        fitCamera();
    }
}

void ViewScene::turn(double rightPixels, double upPixels) {
    fitted_ = false;
    isMovedByUser_ = true;
    style_->turn(rightPixels, upPixels);
}

void ViewScene::fly(const PuckMotion& motion) {
    constexpr double turned = 250; // pixels of a drag, in a second
    constexpr double shifted = 1;  // times the visible height, in a second
    constexpr double zoomed = 1.5; // exponent, in a second
    turn(-turned * motion.turn.y(), turned * motion.turn.x());
    zoom(std::exp(-zoomed * motion.push.z()));
    vtkCamera& own = camera();
    const Eigen::Vector3d focus(own.GetFocalPoint()), place(own.GetPosition());
    const Eigen::Vector3d up(own.GetViewUp());
    const Eigen::Vector3d right =
        Eigen::Vector3d(own.GetDirectionOfProjection()).cross(up).normalized();
    const double height =
        2 * (own.GetParallelProjection()
                 ? own.GetParallelScale()
                 : own.GetDistance() * std::tan(radians(Degrees(own.GetViewAngle())) / 2));
    const Eigen::Vector3d shift =
        -shifted * height * (motion.push.x() * right + motion.push.y() * up.normalized());
    own.SetFocalPoint(Eigen::Vector3d(focus + shift).data());
    own.SetPosition(Eigen::Vector3d(place + shift).data());
}

void ViewScene::zoom(double factor) {
    fitted_ = false;
    isMovedByUser_ = true;
    if (camera().GetParallelProjection()) {
        camera().SetParallelScale(camera().GetParallelScale() / factor);
    } else {
        camera().Dolly(factor);
    }
}

void ViewScene::zoomAt(const QPointF& place, double factor) {
    vtkCamera& own = camera();
    const Eigen::Vector3d focus(own.GetFocalPoint()), ahead(own.GetDirectionOfProjection());
    const Eigen::Vector3d up(own.GetViewUp()), right = ahead.cross(up).normalized();
    const double half =
        own.GetParallelProjection()
            ? own.GetParallelScale()
            : own.GetDistance() * std::tan(radians(Degrees(own.GetViewAngle())) / 2);
    // The vector from the focal point to the place under the cursor, in the plane across the view.
    const QPointF fromMiddle = place - QPointF(size_.size.width() / 2.0, size_.size.height() / 2.0);
    const Eigen::Vector3d aside = 2 * half / std::max(1, size_.size.height()) *
                                  (fromMiddle.x() * right - fromMiddle.y() * right.cross(ahead));
    zoom(factor);
    const Eigen::Vector3d shift = aside * (1 - 1 / factor);
    const Eigen::Vector3d camera = Eigen::Vector3d(own.GetPosition()) + shift;
    own.SetPosition(camera.x(), camera.y(), camera.z());
    own.SetFocalPoint(focus.x() + shift.x(), focus.y() + shift.y(), focus.z() + shift.z());
}

void ViewScene::mouse(const ViewMouse& mouse) {
    const QPoint pixel = (mouse.position * size_.pixelRatio).toPoint();
    interactor_->SetEventInformationFlipY(pixel.x(), pixel.y(),
                                          mouse.modifiers.testFlag(Qt::ControlModifier),
                                          mouse.modifiers.testFlag(Qt::ShiftModifier));
    const ViewCamera before = cameraNow();
    interactor_->InvokeEvent(eventOf(mouse));
    if (cameraNow() != before) {
        fitted_ = false;
        isMovedByUser_ = true;
    }
}

void ViewScene::setCamera(const ViewCamera& wanted) {
    camera().SetPosition(wanted.place.data());
    camera().SetFocalPoint(wanted.focus.data());
    camera().SetViewUp(wanted.up.data());
    camera().SetParallelScale(wanted.scale);
    camera().SetParallelProjection(wanted.isParallel);
    fitted_ = false;
    isMovedByUser_ = false;
}

ViewCamera ViewScene::cameraNow() {
    ViewCamera now;
    camera().GetPosition(now.place.data());
    camera().GetFocalPoint(now.focus.data());
    camera().GetViewUp(now.up.data());
    now.scale = camera().GetParallelScale();
    now.isParallel = camera().GetParallelProjection() != 0;
    return now;
}

ViewPicture ViewScene::draw() {
    static std::mutex oneAtATime; // all windows share VTK's fonts
    const std::lock_guard lock(oneAtATime);
    renderer_->ResetCameraClippingRange();
    if (std::exchange(resized_, false)) {
        window_.vtk()->Render(); // the renderer knows its size only after this
        orientation_->SquareResize();
    }
    ViewPicture picture{window_.draw(), projectionOf(*renderer_, size_.size), cameraNow(),
                        isMovedByUser_};
    picture.image.setDevicePixelRatio(size_.pixelRatio);
    return picture;
}

} // namespace dipwright
