#include "DipView.h"

#include "SpaceMouse.h"
#include "ViewScene.h"
#include "base/PostToThread.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QThread>
#include <QTimer>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace dipwright {

namespace {

constexpr double clickReach = 4;     // pixels that the cursor may move during a click
constexpr int wheelStep = 120;       // Qt's units per notch of the wheel
constexpr double wheelFactor = 1.21; // zoom factor of one notch

} // namespace

// The state on the UI thread: requests, the last picture, and the mouse state.
struct DipView::State {
    PictureWindow window;
    QThread thread; // the thread of `scene`
    QObject drawer; // runs the changes on that thread
    std::unique_ptr<ViewScene> scene;

    QTimer timer;
    bool drawing = false; // a picture is being drawn
    bool again = false;   // another picture is needed after this one
    ViewPicture shown;
    QColor background = Qt::gray, ink = Qt::black;
    std::vector<ViewLegendEntry> legend;

    RotationRings rings;
    QPointF pressed;
    bool leftPressed = false;
    std::vector<std::function<bool(const ViewRay&)>> strokes;
    bool inStroke = false;
    int draggedAxis = -1;
    int litAxis = -1;
    double pressedAngle = 0;
    double draggedAngle = 0;
    MoveArrows arrows;
    int draggedArrow = -1;
    int litArrow = -1;
    // The place on the arrow's axis where the mouse was pressed.
    Eigen::Vector3f heldArrow = Eigen::Vector3f::Zero();
    double draggedWay = 0;
    bool isTyped = false;        // the drag has a typed value and ignores the mouse
    bool ignoresRelease = false; // of the button, because the drag has ended
    QString dragText;
    QPointF pointer; // the place of the mouse during a drag
    std::vector<ViewPin> pins;
    bool catchesPins = true;
    std::optional<SectionPlane> section;
    // During a drag: the place on the section's frame where the mouse was pressed.
    std::optional<Eigen::Vector3f> heldSection;
    bool litSection = false;
    bool isMarked = false; // the linked cursor is shown
    int wheel = 0;         // rotation of the wheel since the last notch

    bool isOnHandle() const { return litAxis >= 0 || litArrow >= 0; }
};

DipView::DipView(QWidget* parent) : QWidget(parent), state_(std::make_unique<State>()) {
    setMinimumSize(240, 180);
    setFocusPolicy(Qt::StrongFocus);
    State& s = *state_;
    if (!isUsable()) {
        auto* layout = new QVBoxLayout(this);
        auto* label = new QLabel(graphicsDevice(), this);
        label->setWordWrap(true);
        label->setAlignment(Qt::AlignCenter);
        layout->addWidget(label);
        return;
    }
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    s.timer.setSingleShot(true);
    s.timer.setInterval(0);
    connect(&s.timer, &QTimer::timeout, this, &DipView::draw);
    s.window.start(s.thread);
    s.drawer.moveToThread(&s.thread);
    s.thread.setObjectName(QStringLiteral("view"));
    s.thread.start();
    connect(&SpaceMouse::shared(), &SpaceMouse::moved, this, [this](const PuckMotion& motion) {
        if (isActiveWindow()) {
            fly(motion);
        }
    });
    postToThread(s.drawer, [this, &s] {
        s.scene = std::make_unique<ViewScene>(
            s.window, [this] { postToThread(*this, [this] { requestPicture(); }); });
    });
}

DipView::~DipView() {
    State& s = *state_;
    if (isUsable()) {
        postToThreadAndWait(s.drawer, [&s] { s.scene.reset(); });
        s.thread.quit();
        s.thread.wait();
    }
}

bool DipView::isUsable() const {
    return state_->window.isUsable();
}

QString DipView::graphicsDevice() const {
    return isUsable() ? state_->window.device()
                      : tr("The 3D view needs OpenGL 3.2, which could not be started. Update the "
                           "graphics driver. Everything else works.");
}

bool DipView::isSoftwareRendered() const {
    const QString device = graphicsDevice();
    return device.contains(QLatin1String("llvmpipe")) ||
           device.contains(QLatin1String("softpipe")) ||
           device.contains(QLatin1String("GDI Generic"));
}

void DipView::change(std::function<void(ViewScene&)> what) {
    if (isUsable()) {
        postToThread(state_->drawer,
                     [s = state_.get(), what = std::move(what)] { what(*s->scene); });
        requestPicture();
    }
}

void DipView::setBody(std::shared_ptr<const TexturedMesh> model) {
    change([model = std::move(model)](ViewScene& scene) { scene.body().setModel(model); });
}

void DipView::setBodyTransform(const Eigen::Isometry3d& modelToWorld) {
    change([modelToWorld](ViewScene& scene) { scene.body().setTransform(modelToWorld); });
}

void DipView::setBodyColours(const std::vector<QRgb>& colours) {
    change([colours](ViewScene& scene) { scene.body().setTriangleColours(colours); });
}

void DipView::setBodyLines(const std::vector<ViewLine>& lines) {
    change([lines](ViewScene& scene) { scene.body().setLines(lines); });
}

void DipView::setBodyPatch(PatchLayer layer, ViewPatch patch) {
    change([layer, patch = std::move(patch)](ViewScene& scene) {
        scene.body().setPatch(layer, patch);
    });
}

void DipView::setBodyVisible(bool visible) {
    change([visible](ViewScene& scene) { scene.body().setVisible(visible); });
}

void DipView::setLegend(std::vector<ViewLegendEntry> entries) {
    state_->legend = std::move(entries);
    update();
}

void DipView::setFilm(FilmShape shape, std::vector<float> positions) {
    change([shape = std::move(shape), positions = std::move(positions)](ViewScene& scene) {
        scene.film().setShape(shape, positions);
    });
}

void DipView::setFilmPositions(std::vector<float> positions) {
    change([positions = std::move(positions)](ViewScene& scene) {
        scene.film().setPositions(positions);
    });
}

void DipView::setFilmTransform(const Eigen::Isometry3d& filmToWorld) {
    change([filmToWorld](ViewScene& scene) { scene.film().setTransform(filmToWorld); });
}

void DipView::setFilmPicture(const QImage& picture) {
    change([picture](ViewScene& scene) { scene.film().setPicture(picture); });
}

void DipView::setFilmColours(std::vector<QRgb> colours) {
    change([colours = std::move(colours)](ViewScene& scene) {
        scene.film().setPointColours(colours);
    });
}

void DipView::setFilmOpacity(double share) {
    change([share](ViewScene& scene) { scene.film().setOpacity(share); });
}

void DipView::setSection(const std::optional<SectionPlane>& section) {
    state_->section = section;
    if (!section) {
        state_->heldSection.reset();
    }
    change([section](ViewScene& scene) { scene.setSection(section); });
}

void DipView::setTank(QSizeF film, double depth) {
    change([film, depth](ViewScene& scene) { scene.setFilmSize(film, depth); });
}

void DipView::setFilmFitted(bool fitted) {
    change([fitted](ViewScene& scene) { scene.setFilmFitted(fitted); });
}

void DipView::setWaterVisible(bool visible) {
    change([visible](ViewScene& scene) { scene.tank().setVisible(visible); });
}

void DipView::setRotationRings(bool visible, const Eigen::Vector3f& centre, double radius) {
    state_->rings = {centre, radius, visible};
    change([rings = state_->rings](ViewScene& scene) { scene.rings().set(rings); });
}

void DipView::setMoveArrows(const std::array<bool, 3>& visible, const Eigen::Vector3f& centre,
                            double begin, double end) {
    state_->arrows = {centre, begin, end, visible};
    change([arrows = state_->arrows](ViewScene& scene) { scene.arrows().set(arrows); });
}

void DipView::setMarker(const std::optional<Eigen::Vector3f>& position) {
    if (!std::exchange(state_->isMarked, position.has_value()) && !position) {
        return; // saves a picture
    }
    change([position](ViewScene& scene) { scene.markers().setMarker(position); });
}

void DipView::setMeasure(const std::vector<Eigen::Vector3f>& places,
                         const std::vector<std::vector<Eigen::Vector3f>>& lines,
                         const QString& label) {
    change([places, lines, label](ViewScene& scene) {
        scene.markers().setMeasure(places, lines, label);
    });
}

void DipView::setPins(std::vector<ViewPin> pins) {
    state_->pins = std::move(pins);
    update();
}

void DipView::setCradle(std::shared_ptr<const TriangleMesh> cradle) {
    change([cradle = std::move(cradle)](ViewScene& scene) { scene.cradle().setMesh(cradle); });
}

void DipView::setCradleTransform(const Eigen::Isometry3d& cradleToWorld) {
    change([cradleToWorld](ViewScene& scene) { scene.cradle().setTransform(cradleToWorld); });
}

void DipView::fly(const PuckMotion& motion) {
    change([motion](ViewScene& scene) { scene.fly(motion); });
}

void DipView::setNavigation(Navigation navigation) {
    change([navigation](ViewScene& scene) { scene.style().setNavigation(navigation); });
}

void DipView::setParallelProjection(bool parallel) {
    change([parallel](ViewScene& scene) { scene.camera().SetParallelProjection(parallel); });
}

void DipView::look(ViewDirection direction) {
    change([direction](ViewScene& scene) { scene.look(direction); });
}

void DipView::lookAt(const Eigen::Vector3f& place, const Eigen::Vector3f& outward) {
    change([place, outward](ViewScene& scene) { scene.lookAt(place, outward); });
}

void DipView::fit() {
    change([](ViewScene& scene) { scene.fit(FittedPlaces::Film); });
}

void DipView::fitBody() {
    change([](ViewScene& scene) { scene.fit(FittedPlaces::Body); });
}

void DipView::fitBodyToHandle() {
    change([](ViewScene& scene) { scene.fit(FittedPlaces::Handles); });
}

void DipView::setCamera(const ViewCamera& camera) {
    change([camera](ViewScene& scene) { scene.setCamera(camera); });
}

void DipView::setColours(const ViewColours& colours) {
    state_->background = colours.bottom;
    state_->ink = colours.ink;
    change([colours](ViewScene& scene) { scene.setColours(colours); });
}

ViewRay DipView::rayAt(QPointF position) const {
    const ViewRay ray = state_->shown.projection.rayAt(position);
    return state_->section ? state_->section->shownPart(ray) : ray;
}

QPointF DipView::positionOf(const Eigen::Vector3f& point) const {
    return state_->shown.projection.positionOf(point);
}

void DipView::requestPicture() {
    State& s = *state_;
    if (!isUsable() || !isVisible()) {
        return;
    }
    if (s.drawing) {
        s.again = true;
    } else if (!s.timer.isActive()) {
        s.timer.start();
    }
}

void DipView::draw() {
    State& s = *state_;
    s.drawing = true;
    postToThread(s.drawer, [this, &s] {
        postToThread(*this, [this, picture = s.scene->draw()] {
            state_->drawing = false;
            take(picture);
        });
    });
}

void DipView::take(const ViewPicture& picture) {
    const bool isMoved = picture.isMovedByUser && picture.camera != state_->shown.camera;
    state_->shown = picture;
    update();
    if (isMoved) {
        emit cameraMoved(picture.camera);
    }
    if (std::exchange(state_->again, false)) {
        requestPicture();
    }
}

void DipView::addStroke(std::function<bool(const ViewRay&)> begins) {
    state_->strokes.push_back(std::move(begins));
}

QImage DipView::picture() {
    if (!isUsable()) {
        return {};
    }
    ViewPicture picture;
    postToThreadAndWait(state_->drawer, [this, &picture] { picture = state_->scene->draw(); });
    take(picture);
    return picture.image;
}

const QImage& DipView::shownPicture() const {
    return state_->shown.image;
}

void DipView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    const QImage& picture = state_->shown.image;
    if (!isUsable()) {
        QWidget::paintEvent(event);
    } else if (picture.isNull()) {
        painter.fillRect(rect(), state_->background);
    } else {
        // Until the next picture is drawn, the size of this one may differ from that of the view.
        painter.drawImage(rect(), picture);
    }
    if (isUsable()) {
        painter.setRenderHint(QPainter::Antialiasing);
        paintPins(painter);
        paintLegend(painter);
        paintDragText(painter);
    }
}

int DipView::pinRadius() const {
    return fontMetrics().height() / 2;
}

bool DipView::facesCamera(const ViewPin& pin) const {
    const ViewProjection& shown = state_->shown.projection;
    return shown.rayAt(shown.positionOf(pin.place)).direction.dot(pin.outward) < 0;
}

void DipView::setCatchPins(bool catches) {
    state_->catchesPins = catches;
}

int DipView::pinAt(const QPointF& position) const {
    if (!state_->catchesPins) {
        return -1;
    }
    for (int pin = int(state_->pins.size()) - 1; pin >= 0; --pin) { // the last is drawn on top
        const ViewPin& candidate = state_->pins[std::size_t(pin)];
        if (QLineF(position, positionOf(candidate.place)).length() <= pinRadius() + 1 &&
            facesCamera(candidate)) {
            return pin;
        }
    }
    return -1;
}

// The pins that face away are drawn first, because others may cover them.
void DipView::paintPins(QPainter& painter) const {
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const double radius = pinRadius();
    for (const bool facing : {false, true}) {
        painter.setOpacity(facing ? 1 : 0.35);
        for (const ViewPin& pin : state_->pins) {
            if (facesCamera(pin) == facing) {
                const QPointF middle = positionOf(pin.place);
                painter.setPen(QPen(Qt::white, 1.5));
                painter.setBrush(pin.colour);
                painter.drawEllipse(middle, radius, radius);
                painter.drawText(
                    QRectF(middle - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)),
                    Qt::AlignCenter, QStringLiteral("!"));
            }
        }
    }
    painter.setOpacity(1);
    painter.setFont(font());
}

void DipView::paintDragText(QPainter& painter) const {
    const State& s = *state_;
    if (!isHandleHeld() || s.dragText.isEmpty()) {
        return;
    }
    const int gap = fontMetrics().height() / 3;
    QRectF box = fontMetrics().boundingRect(s.dragText).adjusted(-2 * gap, -gap, 2 * gap, gap);
    box.moveBottomLeft(s.pointer + QPointF(4 * gap, -2 * gap));
    box.moveRight(std::min(box.right(), double(width() - gap)));
    box.moveTop(std::max(box.top(), double(gap)));
    QColor ground = s.background;
    ground.setAlpha(225);
    painter.setPen(s.ink);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, gap, gap);
    painter.drawText(box, Qt::AlignCenter, s.dragText);
}

bool DipView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto& help = static_cast<QHelpEvent&>(*event);
        const int pin = pinAt(help.pos());
        if (pin >= 0) {
            QToolTip::showText(help.globalPos(), state_->pins[std::size_t(pin)].text, this);
            return true;
        }
    }
    return QWidget::event(event);
}

void DipView::paintLegend(QPainter& painter) const {
    if (state_->legend.empty()) {
        return;
    }
    const int line = fontMetrics().height(), gap = line / 2;
    int widest = 0;
    for (const ViewLegendEntry& entry : state_->legend) {
        widest = std::max(widest, fontMetrics().horizontalAdvance(entry.text));
    }
    const int count = int(state_->legend.size());
    QRect box(0, 0, widest + 2 * line + 3 * gap, count * (line + gap) + gap);
    box.moveBottomLeft(rect().bottomLeft() + QPoint(gap, -gap));
    QColor ground = state_->background;
    ground.setAlpha(225);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, gap, gap);
    QPoint place = box.topLeft() + QPoint(gap, gap);
    for (const ViewLegendEntry& entry : state_->legend) {
        painter.setPen(state_->ink);
        painter.setBrush(entry.colour);
        painter.drawRect(QRectF(place, QSizeF(2 * line, line)).adjusted(0.5, 1.5, -0.5, -1.5));
        painter.drawText(QRect(place.x() + 2 * line + gap, place.y(), widest, line),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, entry.text);
        place.ry() += line + gap;
    }
}

void DipView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    updateSize();
}

void DipView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    updateSize();
}

void DipView::updateSize() {
    change([size = ViewSize{this->size(), devicePixelRatioF(), font().pointSizeF()}](
               ViewScene& scene) { scene.setSize(size); });
}

void DipView::sendMouse(const ViewMouse& mouse) {
    if (isUsable()) {
        postToThread(state_->drawer, [s = state_.get(), mouse] { s->scene->mouse(mouse); });
    }
}

void DipView::mousePressEvent(QMouseEvent* event) {
    State& s = *state_;
    s.pressed = s.pointer = event->position();
    s.ignoresRelease = false;
    s.leftPressed = event->button() == Qt::LeftButton;
    if (s.leftPressed && holdHandle()) {
        if (isHandleHeld()) {
            emit handleHeld(s.draggedAxis >= 0);
        }
        emit hoverLeft(); // what lies under the cursor moves away from it
        return;
    }
    const ViewRay ray = rayAt(s.pressed);
    s.inStroke = s.leftPressed && std::any_of(s.strokes.begin(), s.strokes.end(),
                                              [&](const auto& begins) { return begins(ray); });
    if (s.inStroke) {
        emit stroked(ray);
        return;
    }
    sendMouse({MouseAction::Press, event->button(), event->position(), event->modifiers()});
}

// Starts dragging the handle under the mouse: an arrow, a ring or the section's frame.
bool DipView::holdHandle() {
    State& s = *state_;
    s.isTyped = false;
    s.dragText.clear();
    const ViewProjection& shown = s.shown.projection;
    if (const auto arrow = s.arrows.axisAt(s.pressed, shown)) {
        s.draggedArrow = *arrow;
        s.draggedWay = 0;
        s.heldArrow = s.arrows.centre;
        s.heldArrow[*arrow] = float(placeAlong(*arrow, s.arrows.centre, shown.rayAt(s.pressed)));
        return true;
    }
    if (const auto axis = s.rings.axisAt(s.pressed, shown)) {
        s.draggedAxis = *axis;
        s.draggedAngle = 0;
        s.pressedAngle = s.rings.angleAt(*axis, s.pressed, shown);
        return true;
    }
    if (s.section) {
        s.heldSection = s.section->frameAt(s.pressed, shown);
    }
    return s.heldSection.has_value();
}

void DipView::mouseMoveEvent(QMouseEvent* event) {
    State& s = *state_;
    s.pointer = event->position();
    if (isHandleHeld() && s.isTyped) {
        update(); // the text follows the pointer
        return;
    }
    if (s.draggedAxis >= 0) {
        dragRing(*event);
        return;
    }
    if (s.draggedArrow >= 0) {
        dragArrow(*event);
        return;
    }
    if (s.heldSection) {
        dragSection(event->position());
        return;
    }
    if (s.inStroke) {
        emit stroked(rayAt(event->position()));
        return;
    }
    if (event->buttons() == Qt::NoButton) {
        lightHandles(event->position());
        lightSection(event->position());
        if (!s.isOnHandle() && !s.litSection) {
            setCursor(pinAt(event->position()) >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
        }
        emit hovered(rayAt(event->position()));
    }
    sendMouse({MouseAction::Move, Qt::NoButton, event->position(), event->modifiers()});
}

void DipView::dragRing(const QMouseEvent& event) {
    State& s = *state_;
    const double angle = s.rings.angleAt(s.draggedAxis, event.position(), s.shown.projection);
    double turned = std::remainder(angle - s.pressedAngle, 360);
    if (event.modifiers() & Qt::ShiftModifier) {
        turned = std::round(turned / ringStep) * ringStep;
    }
    dragTo(std::round(10 * turned) / 10);
}

void DipView::dragTo(double value) {
    State& s = *state_;
    if (s.draggedAxis >= 0 && value != s.draggedAngle) {
        s.draggedAngle = value;
        emit rotationDragged(s.draggedAxis, value);
    } else if (s.draggedArrow >= 0 && value != s.draggedWay) {
        s.draggedWay = value;
        emit moveDragged(s.draggedArrow, value);
    }
}

bool DipView::isHandleHeld() const {
    return state_->draggedAxis >= 0 || state_->draggedArrow >= 0;
}

void DipView::setDragValue(std::optional<double> value) {
    state_->isTyped = value.has_value();
    if (value) {
        dragTo(*value);
    }
}

void DipView::setDragText(const QString& text) {
    state_->dragText = text;
    update();
}

void DipView::releaseHandle() {
    State& s = *state_;
    s.ignoresRelease = isHandleHeld();
    if (std::exchange(s.draggedAxis, -1) >= 0) {
        emit rotationFinished();
    }
    if (std::exchange(s.draggedArrow, -1) >= 0) {
        emit moveFinished();
    }
    update();
}

void DipView::dragArrow(const QMouseEvent& event) {
    State& s = *state_;
    const int axis = s.draggedArrow;
    const ViewRay ray = s.shown.projection.rayAt(event.position());
    double way = placeAlong(axis, s.heldArrow, ray) - double(s.heldArrow[axis]);
    if (event.modifiers() & Qt::ShiftModifier) {
        way = std::round(way / arrowStep) * arrowStep;
    }
    dragTo(std::round(10 * way) / 10);
}

void DipView::lightHandles(const QPointF& position) {
    State& s = *state_;
    const int arrow = s.arrows.axisAt(position, s.shown.projection).value_or(-1);
    const int ring = arrow >= 0 ? -1 : s.rings.axisAt(position, s.shown.projection).value_or(-1);
    if (ring != s.litAxis || arrow != s.litArrow) {
        s.litAxis = ring;
        s.litArrow = arrow;
        change([ring, arrow](ViewScene& scene) {
            scene.rings().highlight(ring);
            scene.arrows().highlight(arrow);
        });
        setCursor(s.isOnHandle() ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
}

// The motion is measured from the place where the drag began, so that the plane does not jump.
void DipView::dragSection(const QPointF& position) {
    const SectionPlane& section = *state_->section;
    const int axis = section.axis;
    const double place =
        placeAlong(axis, *state_->heldSection, state_->shown.projection.rayAt(position));
    emit sectionDragged(
        std::clamp(place, double(section.extent.min()[axis]), double(section.extent.max()[axis])));
}

void DipView::lightSection(const QPointF& position) {
    State& s = *state_;
    const bool lit = s.section && !s.isOnHandle() &&
                     s.section->frameAt(position, s.shown.projection).has_value();
    if (lit != s.litSection) {
        s.litSection = lit;
        change([lit](ViewScene& scene) { scene.sectionFrame().highlight(lit); });
        setCursor(lit              ? Qt::SizeAllCursor
                  : s.isOnHandle() ? Qt::PointingHandCursor
                                   : Qt::ArrowCursor);
    }
}

void DipView::mouseReleaseEvent(QMouseEvent* event) {
    State& s = *state_;
    if (isHandleHeld()) {
        releaseHandle();
        s.ignoresRelease = false;
        return;
    }
    if (std::exchange(s.ignoresRelease, false)) {
        return;
    }
    if (std::exchange(s.heldSection, std::nullopt)) {
        return;
    }
    if (std::exchange(s.inStroke, false)) {
        emit strokeFinished();
        return;
    }
    const QPointF moved = event->position() - s.pressed;
    const bool still = std::hypot(moved.x(), moved.y()) <= clickReach;
    if (still && event->button() == Qt::LeftButton) {
        const int pin = pinAt(event->position());
        if (pin >= 0) {
            emit pinClicked(pin);
        } else {
            emit clicked(rayAt(event->position()));
        }
    }
    sendMouse({MouseAction::Release, event->button(), event->position(), event->modifiers()});
    if (still && event->button() == Qt::RightButton) {
        emit menuRequested(rayAt(event->position()), event->globalPosition().toPoint());
    }
}

// Handles only the menu key. The right button opens the menu on release, because a drag with it
// moves the camera.
void DipView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() == QContextMenuEvent::Keyboard) {
        const QPoint middle = rect().center();
        emit menuRequested(rayAt(middle), mapToGlobal(middle));
    }
}

void DipView::wheelEvent(QWheelEvent* event) {
    int& turned = state_->wheel;
    for (turned += event->angleDelta().y(); std::abs(turned) >= wheelStep;) {
        const bool forward = turned > 0;
        turned -= forward ? wheelStep : -wheelStep;
        change([place = event->position(), factor = forward ? wheelFactor : 1 / wheelFactor](
                   ViewScene& scene) { scene.zoomAt(place, factor); });
    }
}

void DipView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    emit hoverLeft();
}

void DipView::keyPressEvent(QKeyEvent* event) {
    constexpr double step = 25; // a key turns the camera like a drag of this many pixels
    const auto turn = [this](double right, double up) {
        change([right, up](ViewScene& scene) { scene.turn(right, up); });
    };
    const auto zoom = [this](double factor) {
        change([factor](ViewScene& scene) { scene.zoom(factor); });
    };
    switch (event->key()) {
    case Qt::Key_Left:
        return turn(-step, 0);
    case Qt::Key_Right:
        return turn(step, 0);
    case Qt::Key_Up:
        return turn(0, step);
    case Qt::Key_Down:
        return turn(0, -step);
    case Qt::Key_Plus:
        return zoom(1.1);
    case Qt::Key_Minus:
        return zoom(1 / 1.1);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace dipwright
