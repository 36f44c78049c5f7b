// The 3D view of a dip: body, film, water and tank, with camera, handles and rays under the cursor.
//
// World frame: millimetres, right-handed, Y up; the waterline is the plane y = 0. The view only
// draws the data that it is given; it does not know projects or solvers. UI thread only.
//
// Pictures are drawn on the view's own thread, so the window never waits for one.
#pragma once

#include "SectionPlane.h"
#include "ViewLine.h"
#include "ViewPatch.h"
#include "ViewProjection.h"
#include "model/TexturedMesh.h"

#include <Eigen/Geometry>
#include <QColor>
#include <QImage>
#include <QWidget>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

class QPainter;

namespace dipwright {

class ViewScene;
struct PuckMotion;
struct ViewMouse;
struct ViewPicture;

// With Shift held, rings and arrows move the body in these steps.
inline constexpr double ringStep = 15; // degrees
inline constexpr double arrowStep = 5; // mm

// How a drag with the left button turns the camera.
enum class Navigation {
    Turntable, // the world's Y axis stays vertical
    Trackball, // turns freely
};

enum class ViewDirection { Front, Back, Left, Right, Top, Bottom, Oblique };

// The topology of the film as it is drawn. `texture` has one coordinate (u to the right, v down the
// sheet, 0 … 1) for each point. Triangles with a side longer than `longestSide` (mm) are not drawn:
// they are torn, or lie between released film and film on the body. Film that is `isOnBody` is
// shaded like the body; other film is nearly evenly bright.
struct FilmShape {
    std::vector<Eigen::Vector2f> texture;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    float longestSide = std::numeric_limits<float>::infinity();
    bool isOnBody = false;
};

struct ViewColours {
    QColor top, bottom; // background gradient
    QColor ink;         // lines and labels
    QColor accent;      // handles and cursor
    QColor water;
};

// Explains one of the body's colours.
struct ViewLegendEntry {
    QColor colour;
    QString text;
};

// A mark on the body that the user can click, such as a warning.
struct ViewPin {
    Eigen::Vector3f place; // on the body, world
    // From the body, world. A pin that faces away is faint, and clicks do not meet it.
    Eigen::Vector3f outward;
    QColor colour;
    QString text; // its tooltip
};

class DipView : public QWidget {
    Q_OBJECT

public:
    explicit DipView(QWidget* parent = nullptr);
    ~DipView() override;

    // Returns false if no OpenGL 3.2 context could be created; `graphicsDevice` then returns the
    // reason.
    bool isUsable() const;
    // Returns the renderer's name as the driver reports it.
    QString graphicsDevice() const;
    // Returns whether the renderer works without a GPU. Callers then draw less during motion.
    bool isSoftwareRendered() const;

    // Sets the body. `model` has its own coordinates; null means no body.
    void setBody(std::shared_ptr<const TexturedMesh> model);
    void setBodyTransform(const Eigen::Isometry3d& modelToWorld);
    // Sets one colour for each triangle instead of the texture. If `colours` is empty, shows the
    // texture.
    void setBodyColours(const std::vector<QRgb>& colours);
    // Sets lines on the body's surface. They are drawn over the surface.
    void setBodyLines(const std::vector<ViewLine>& lines);
    // Colours a part of the surface over the body's own colours. No triangles: nothing.
    void setBodyPatch(PatchLayer layer, ViewPatch patch);
    void setBodyVisible(bool visible);
    // Sets the legend in the lower left corner, in this order. If empty, no legend is shown.
    void setLegend(std::vector<ViewLegendEntry> entries);

    // Sets the film. `positions` holds x, y, z for each point; setFilmTransform() maps them to the
    // world.
    void setFilm(FilmShape shape, std::vector<float> positions);
    void setFilmPositions(std::vector<float> positions); // x, y, z for each point of the shape
    void setFilmTransform(const Eigen::Isometry3d& filmToWorld);
    void setFilmPicture(const QImage& picture); // clears the colours
    // One colour for each point; empty: the picture is shown.
    void setFilmColours(std::vector<QRgb> colours);
    void setFilmOpacity(double share); // 1: opaque

    // Cuts body and film open, or shows them whole without a section. Rays then start on the drawn
    // side.
    void setSection(const std::optional<SectionPlane>& section);

    // Draws the tank, and a frame of water around the film. `film` is the film's floating size,
    // `depth` the depth of the tank, in mm.
    void setTank(QSizeF film, double depth);
    void setWaterVisible(bool visible);

    // Shows the three rings that turn the body, around `centre` (world).
    void setRotationRings(bool visible, const Eigen::Vector3f& centre, double radius);

    // Shows the arrows that move the body along X, Y and Z. They reach from `begin` to `end` mm
    // from `centre` (world).
    void setMoveArrows(const std::array<bool, 3>& visible, const Eigen::Vector3f& centre,
                       double begin, double end);

    // Shows the linked cursor at `position` (world); nullopt hides it.
    void setMarker(const std::optional<Eigen::Vector3f>& position);
    // Shows up to two places with the lines between them and their label (world); no places hide
    // them.
    void setMeasure(const std::vector<Eigen::Vector3f>& places,
                    const std::vector<std::vector<Eigen::Vector3f>>& lines, const QString& label);

    void setPins(std::vector<ViewPin> pins);
    // Whether pins take clicks and show their texts. If not, the body under them is clicked.
    void setCatchPins(bool catches);

    // Shows a cradle, translucent; null: none. `cradleToWorld` maps its coordinates.
    void setCradle(std::shared_ptr<const TriangleMesh> cradle);
    void setCradleTransform(const Eigen::Isometry3d& cradleToWorld);

    // Whether the user drags a ring or an arrow.
    bool isHandleHeld() const;
    // Sets the drag to this angle in degrees, or to this distance in mm. It no longer follows the
    // mouse until the value is nullopt again or the handle is released.
    void setDragValue(std::optional<double> value);
    // Ends the drag before the mouse button is released.
    void releaseHandle();
    // Shows a text beside the pointer while a handle is held.
    void setDragText(const QString& text);

    // Moves the camera as a SpaceMouse asks: the body follows the puck.
    void fly(const PuckMotion& motion);

    // Adds a callback for presses of the left button. Each press is offered to the callbacks in
    // order until one returns true. The drag is then a stroke and does not move the camera.
    void addStroke(std::function<bool(const ViewRay&)> begins);

    // Sets how a drag with the left button turns the camera.
    void setNavigation(Navigation navigation);
    void setParallelProjection(bool parallel);
    void look(ViewDirection direction); // fits the view as the last fit did
    // Points the camera at a place on the body. `outward` is the direction from the body towards
    // the camera.
    void lookAt(const Eigen::Vector3f& place, const Eigen::Vector3f& outward);
    void fit();
    void fitBody();         // shows the body as large as possible
    void fitBodyToHandle(); // shows the body with its rings and arrows
    // Sets whether fit() shows body and film, or only the body. If fit() placed the camera last,
    // the camera is fitted again.
    void setFilmFitted(bool fitted);
    // Places the camera as in another view, see cameraMoved().
    void setCamera(const ViewCamera& camera);
    void setColours(const ViewColours& colours);
    // Returns the ray under a position in widget coordinates, for the last drawn picture.
    ViewRay rayAt(QPointF position) const;
    QPointF positionOf(const Eigen::Vector3f& point) const;

    // Returns a picture of the current state at the view's size. Waits until it has been drawn.
    QImage picture();
    const QImage& shownPicture() const; // the last drawn picture; null before the first picture
    // Requests a new picture. All requests during drawing cause only one more picture.
    void requestPicture();

signals:
    void hovered(const dipwright::ViewRay& ray);
    void hoverLeft();
    // The left button was pressed and released at the same place.
    void clicked(const dipwright::ViewRay& ray);
    // The right button was pressed and released at the same place, or the menu key was pressed.
    // `place` is on the screen.
    void menuRequested(const dipwright::ViewRay& ray, const QPoint& place);
    void stroked(const dipwright::ViewRay& ray); // emitted at the press and during the stroke
    void strokeFinished();
    // A ring (`turns`) or an arrow was pressed.
    void handleHeld(bool turns);
    // Angle since the press, about the world's X, Y or Z. The mouse moves in steps of 0.1°.
    void rotationDragged(int axis, double degrees);
    void rotationFinished();
    // Distance since the press, along the world's X, Y or Z. The mouse moves in steps of 0.1 mm.
    void moveDragged(int axis, double millimetres);
    void moveFinished();
    // A picture was drawn with a camera that the user moved in this view. Not emitted after
    // setCamera(), so that linked views do not react to each other endlessly.
    void cameraMoved(const dipwright::ViewCamera& camera);
    void pinClicked(int pin);          // its number in setPins()
    void sectionDragged(double place); // `place`: mm along the section's axis

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    struct State;
    // Calls `what` on the drawing thread before it draws the next picture.
    void change(std::function<void(ViewScene&)> what);
    void sendMouse(const ViewMouse& mouse);
    void updateSize();
    void draw();
    void take(const ViewPicture& picture);
    void dragRing(const QMouseEvent& event);
    void dragArrow(const QMouseEvent& event);
    void dragTo(double value);
    bool holdHandle();
    void lightHandles(const QPointF& position);
    void dragSection(const QPointF& position);
    void lightSection(const QPointF& position);
    void paintLegend(QPainter& painter) const;
    void paintPins(QPainter& painter) const;
    void paintDragText(QPainter& painter) const;
    int pinRadius() const; // pixels
    bool facesCamera(const ViewPin& pin) const;
    int pinAt(const QPointF& position) const; // −1: none

    std::unique_ptr<State> state_;
};

} // namespace dipwright
