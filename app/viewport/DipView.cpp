#include "DipView.h"

#include "BodyActors.h"
#include "FilmActor.h"
#include "MarkerActors.h"
#include "NavigationStyle.h"
#include "RotationRings.h"
#include "TankActors.h"
#include "VtkConversions.h"
#include "base/Units.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>
#include <QVBoxLayout>
#include <QVTKOpenGLNativeWidget.h>
#include <cmath>
#include <limits>
#include <utility>
#include <vtkCamera.h>
#include <vtkCameraOrientationRepresentation.h>
#include <vtkCameraOrientationWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkRenderWindowInteractor.h>

namespace dipwright {

namespace {

constexpr double clickReach = 4; // pixels that a click may move

bool canMakeContext(QString& reason) {
    QOpenGLContext context;
    context.setFormat(QSurfaceFormat::defaultFormat());
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface)) {
        reason = DipView::tr("The 3D view needs OpenGL 3.2, and no such context could be made. "
                             "Everything else works.");
        return false;
    }
    return true;
}

// Moves the camera, without turning it, to where it shows all places as large as can be and in the
// middle.
void fitCamera(vtkCamera& camera, const std::vector<Eigen::Vector3d>& places, double aspect) {
    constexpr double room = 1.06; // some round the places
    const Eigen::Vector3d view = Eigen::Vector3d(camera.GetDirectionOfProjection()).normalized();
    const Eigen::Vector3d right = view.cross(Eigen::Vector3d(camera.GetViewUp())).normalized();
    const Eigen::Vector3d up = right.cross(view);
    const double down = std::tan(radians(Degrees(camera.GetViewAngle())) / 2) / room;
    const bool parallel = camera.GetParallelProjection() != 0;
    // Along an axis of the picture: the middle, and how far the camera stands away from it (or, in
    // parallel projection, half of what it shows), so that no place is past either edge.
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

} // namespace

struct DipView::Scene {
    explicit Scene(DipView* view) : timer(view) {
        timer.setSingleShot(true);
        timer.setInterval(0);
    }

    QVTKOpenGLNativeWidget* widget = nullptr; // null: not usable
    QString reason;
    QTimer timer;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkOpenGLRenderer> renderer;
    vtkNew<NavigationStyle> style;
    vtkNew<vtkCameraOrientationWidget> orientation;
    BodyActors body{renderer};
    FilmActor film{renderer};
    TankActors tank{renderer};
    RotationRings rings{renderer};
    MarkerActors markers{renderer};

    QSizeF filmSize{210, 297};
    QPointF pressed;
    bool leftPressed = false;
    bool shown = false;
    int pictureTime = 0;
    int draggedAxis = -1;
    int litAxis = -1;
    double pressedAngle = 0;
    double draggedAngle = 0;

    double sceneSize() const { return std::hypot(filmSize.width(), filmSize.height()); }
};

void DipView::prepareSurfaceFormat() {
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0); // edges are smoothed in the picture instead: that is cheap without a GPU
    QSurfaceFormat::setDefaultFormat(format);
}

DipView::DipView(QWidget* parent) : QWidget(parent), scene_(std::make_unique<Scene>(this)) {
    setMinimumSize(240, 180);
    setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    Scene& s = *scene_;
    if (!canMakeContext(s.reason)) {
        auto* label = new QLabel(s.reason, this);
        label->setWordWrap(true);
        label->setAlignment(Qt::AlignCenter);
        layout->addWidget(label);
        return;
    }
    s.widget = new QVTKOpenGLNativeWidget(this);
    s.widget->setRenderWindow(s.window);
    s.widget->setMouseTracking(true);
    s.widget->setFocusPolicy(Qt::NoFocus);
    s.widget->installEventFilter(this);
    installEventFilter(this);
    layout->addWidget(s.widget);

    s.window->SetMultiSamples(0);
    s.window->AddRenderer(s.renderer);
    s.renderer->UseFXAAOn();
    s.renderer->GradientBackgroundOn();
    s.style->SetDefaultRenderer(s.renderer);
    s.style->SetCurrentRenderer(s.renderer);
    s.window->GetInteractor()->SetInteractorStyle(s.style);
    s.orientation->SetParentRenderer(s.renderer);
    s.orientation->SetAnimate(false); // its animation would block the event loop
    s.orientation->On();
    connect(&s.timer, &QTimer::timeout, this, &DipView::render);
    s.markers.setSize(s.sceneSize());
    look(ViewDirection::Oblique);
}

DipView::~DipView() {
    if (scene_->widget) {
        scene_->orientation->Off();
    }
}

bool DipView::isUsable() const {
    return scene_->widget != nullptr;
}

QString DipView::graphicsDevice() const {
    if (!isUsable()) {
        return scene_->reason;
    }
    const QString report = QString::fromUtf8(scene_->window->ReportCapabilities());
    for (const QString& line : report.split(QLatin1Char('\n'))) {
        if (line.contains(QLatin1String("renderer string"))) {
            return line.section(QLatin1Char(':'), 1).trimmed();
        }
    }
    return tr("unknown");
}

bool DipView::isSoftwareRendered() const {
    const QString device = graphicsDevice();
    return device.contains(QLatin1String("llvmpipe")) ||
           device.contains(QLatin1String("softpipe")) ||
           device.contains(QLatin1String("GDI Generic"));
}

void DipView::setBody(std::shared_ptr<const TexturedMesh> model) {
    scene_->body.setModel(std::move(model));
    requestPicture();
}

void DipView::setBodyTransform(const Eigen::Isometry3d& modelToWorld) {
    scene_->body.setTransform(modelToWorld);
    requestPicture();
}

void DipView::setBodyColours(const std::vector<QRgb>& colours) {
    scene_->body.setTriangleColours(colours);
    requestPicture();
}

void DipView::setBodyVisible(bool visible) {
    scene_->body.setVisible(visible);
    requestPicture();
}

void DipView::setFilm(const FilmShape& shape, std::span<const float> positions) {
    scene_->film.setShape(shape, positions);
    requestPicture();
}

void DipView::setFilmPositions(std::span<const float> positions) {
    scene_->film.setPositions(positions);
    requestPicture();
}

void DipView::setFilmTransform(const Eigen::Isometry3d& filmToWorld) {
    scene_->film.setTransform(filmToWorld);
    requestPicture();
}

void DipView::setFilmPicture(const QImage& picture) {
    scene_->film.setPicture(picture);
    requestPicture();
}

void DipView::setFilmColours(const std::vector<QRgb>& colours) {
    scene_->film.setPointColours(colours);
    requestPicture();
}

void DipView::setFilmVisible(bool visible) {
    scene_->film.setVisible(visible);
    requestPicture();
}

void DipView::setTank(QSizeF film, double depth) {
    scene_->filmSize = film;
    scene_->tank.setSize(film, depth);
    scene_->markers.setSize(scene_->sceneSize());
    requestPicture();
}

void DipView::setWaterVisible(bool visible) {
    scene_->tank.setVisible(visible);
    requestPicture();
}

void DipView::setRotationRings(bool visible, const Eigen::Vector3f& centre, double radius) {
    scene_->rings.setPlace(centre, radius);
    scene_->rings.setVisible(visible);
    requestPicture();
}

void DipView::setMarker(const std::optional<Eigen::Vector3f>& position) {
    scene_->markers.setMarker(position);
    requestPicture();
}

void DipView::setMeasure(const std::vector<Eigen::Vector3f>& points, const QString& label) {
    scene_->markers.setMeasure(points, label);
    requestPicture();
}

void DipView::setNavigation(Navigation navigation) {
    scene_->style->setNavigation(navigation);
}

void DipView::setParallelProjection(bool parallel) {
    scene_->renderer->GetActiveCamera()->SetParallelProjection(parallel);
    requestPicture();
}

bool DipView::isParallelProjection() const {
    return scene_->renderer->GetActiveCamera()->GetParallelProjection() != 0;
}

void DipView::look(ViewDirection direction) {
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
    setCameraAngles(*scene_->renderer->GetActiveCamera(), angles);
    fit();
}

void DipView::fit() {
    const Scene& s = *scene_;
    const double margin = 2 * TankActors::margin(s.filmSize);
    const Eigen::Vector3f half(float(s.filmSize.width() + margin) / 2, 1,
                               float(s.filmSize.height() + margin) / 2);
    std::vector<Eigen::Vector3d> places;
    for (const BoundingBox& box : {s.body.worldBox(), BoundingBox(-half, half)}) {
        for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
            places.emplace_back(box.corner(BoundingBox::CornerType(corner)).cast<double>());
        }
    }
    const double aspect = double(std::max(1, width())) / std::max(1, height());
    fitCamera(*s.renderer->GetActiveCamera(), places, aspect);
    s.renderer->ResetCameraClippingRange();
    requestPicture();
}

void DipView::setColours(const ViewColours& colours) {
    const Scene& s = *scene_;
    s.renderer->SetBackground(vtkColour(colours.bottom).data());
    s.renderer->SetBackground2(vtkColour(colours.top).data());
    scene_->tank.setColours(colours.water, colours.ink);
    scene_->body.setWaterlineColour(colours.accent);
    scene_->markers.setColours(colours.accent, colours.ink);
    requestPicture();
}

ViewRay DipView::rayAt(QPointF position) const {
    const double ratio = devicePixelRatioF();
    const auto world = [&](double depth) {
        vtkRenderer* renderer = scene_->renderer;
        renderer->SetDisplayPoint(position.x() * ratio, (height() - 1 - position.y()) * ratio,
                                  depth);
        renderer->DisplayToWorld();
        const double* point = renderer->GetWorldPoint();
        return Eigen::Vector3d(Eigen::Vector3d(point[0], point[1], point[2]) / point[3]);
    };
    const Eigen::Vector3d near = world(0), far = world(1);
    return {near.cast<float>(), (far - near).normalized().cast<float>()};
}

QPointF DipView::positionOf(const Eigen::Vector3f& point) const {
    vtkRenderer* renderer = scene_->renderer;
    renderer->SetWorldPoint(point.x(), point.y(), point.z(), 1);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const double ratio = devicePixelRatioF();
    return {display[0] / ratio, height() - 1 - display[1] / ratio};
}

QImage DipView::picture() {
    if (!isUsable()) {
        return {};
    }
    render();
    return scene_->widget->grabFramebuffer();
}

void DipView::requestPicture() {
    if (isUsable() && isVisible() && !scene_->timer.isActive()) {
        scene_->timer.start();
    }
}

void DipView::render() {
    if (!std::exchange(scene_->shown, true)) {
        fit(); // only now is the picture's shape known
    }
    QElapsedTimer clock;
    clock.start();
    scene_->renderer->ResetCameraClippingRange();
    scene_->window->Render();
    scene_->pictureTime = int(clock.elapsed());
}

int DipView::pictureTime() const {
    return scene_->pictureTime;
}

void DipView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (!isUsable()) {
        return;
    }
    const double ratio = devicePixelRatioF();
    scene_->markers.setFontSize(int(font().pointSizeF() * 1.6 * ratio));
    scene_->rings.setPixelRatio(ratio);
    scene_->tank.setPixelRatio(ratio);
    scene_->body.setPixelRatio(ratio);
    scene_->markers.setPixelRatio(ratio);
    auto* axes =
        vtkCameraOrientationRepresentation::SafeDownCast(scene_->orientation->GetRepresentation());
    axes->SetSize(int(84 * ratio), int(84 * ratio));
    axes->SetPadding(int(14 * ratio), int(14 * ratio));
    requestPicture();
}

bool DipView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == this) {
        return event->type() == QEvent::KeyPress && keyPressed(static_cast<QKeyEvent*>(event));
    }
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        setFocus(Qt::MouseFocusReason);
        return mousePressed(static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
        return mouseMoved(static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
        return mouseReleased(static_cast<QMouseEvent*>(event));
    case QEvent::Leave:
        emit hoverLeft();
        return false;
    default:
        return false;
    }
}

bool DipView::mousePressed(QMouseEvent* event) {
    Scene& s = *scene_;
    s.pressed = event->position();
    s.leftPressed = event->button() == Qt::LeftButton;
    if (!s.leftPressed) {
        return false;
    }
    const auto project = [this](const Eigen::Vector3f& point) { return positionOf(point); };
    if (const auto axis = s.rings.axisAt(s.pressed, project)) {
        s.draggedAxis = *axis;
        s.draggedAngle = 0;
        s.pressedAngle = s.rings.angleAt(*axis, s.pressed, project);
        return true;
    }
    return false;
}

bool DipView::mouseMoved(QMouseEvent* event) {
    Scene& s = *scene_;
    const auto project = [this](const Eigen::Vector3f& point) { return positionOf(point); };
    if (s.draggedAxis >= 0) {
        const double angle = s.rings.angleAt(s.draggedAxis, event->position(), project);
        double turned = std::remainder(angle - s.pressedAngle, 360);
        if (event->modifiers() & Qt::ShiftModifier) {
            turned = std::round(turned / 15) * 15;
        }
        if (turned != s.draggedAngle) {
            s.draggedAngle = turned;
            emit rotationDragged(s.draggedAxis, turned);
        }
        return true;
    }
    if (event->buttons() == Qt::NoButton) {
        const int lit = s.rings.axisAt(event->position(), project).value_or(-1);
        if (lit != s.litAxis) {
            s.litAxis = lit;
            s.rings.highlight(lit);
            s.widget->setCursor(lit >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
            requestPicture();
        }
        emit hovered(rayAt(event->position()));
    }
    return false;
}

bool DipView::mouseReleased(QMouseEvent* event) {
    Scene& s = *scene_;
    if (s.draggedAxis >= 0) {
        s.draggedAxis = -1;
        emit rotationFinished();
        return true;
    }
    const QPointF moved = event->position() - s.pressed;
    const bool still = std::hypot(moved.x(), moved.y()) <= clickReach;
    if (still && event->button() == Qt::LeftButton) {
        emit clicked(rayAt(event->position()));
    }
    return false;
}

bool DipView::keyPressed(QKeyEvent* event) {
    Scene& s = *scene_;
    constexpr double step = 25; // pixels of a drag
    switch (event->key()) {
    case Qt::Key_Left:
        s.style->turn(-step, 0);
        break;
    case Qt::Key_Right:
        s.style->turn(step, 0);
        break;
    case Qt::Key_Up:
        s.style->turn(0, step);
        break;
    case Qt::Key_Down:
        s.style->turn(0, -step);
        break;
    case Qt::Key_Plus:
        s.renderer->GetActiveCamera()->Dolly(1.1);
        break;
    case Qt::Key_Minus:
        s.renderer->GetActiveCamera()->Dolly(1 / 1.1);
        break;
    default:
        return false;
    }
    requestPicture();
    return true;
}

} // namespace dipwright
