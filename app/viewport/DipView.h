// The 3D view of a dip: body, film, water and tank, with camera, handles and rays under the cursor.
//
// World frame: millimetres, right-handed, Y up; the waterline is the plane y = 0. The view draws
// what it is given; it knows no project and no solver. UI thread only.
//
// Pictures are drawn on the view's own thread, so the window never waits for one.
#pragma once

#include "SectionPlane.h"
#include "ViewLine.h"
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
struct ViewMouse;
struct ViewPicture;

// With Shift held, rings and arrows move the body by these steps.
inline constexpr double ringStep = 15; // degrees
inline constexpr double arrowStep = 5; // mm

// How a drag with the left button turns the camera.
enum class Navigation {
    Turntable, // the world's Y axis stays vertical
    Trackball, // turns freely
};

enum class ViewDirection { Front, Back, Left, Right, Top, Bottom, Oblique };

// The topology of the film as drawn. `texture` has one coordinate (u to the right, v down the
// sheet, 0 … 1) for each point. A triangle with a side longer than `longestSide` (mm) is not drawn:
// it is torn, or lies between released film and film on the body.
struct FilmShape {
    std::vector<Eigen::Vector2f> texture;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    float longestSide = std::numeric_limits<float>::infinity();
};

struct ViewColours {
    QColor top, bottom; // background gradient
    QColor ink;         // lines and labels
    QColor accent;      // handles and cursor
    QColor water;
};

// The meaning of one of the body's colours.
struct ViewLegendEntry {
    QColor colour;
    QString text;
};

class DipView : public QWidget {
    Q_OBJECT

public:
    explicit DipView(QWidget* parent = nullptr);
    ~DipView() override;

    // False if no OpenGL 3.2 context could be created; `graphicsDevice` then gives the reason.
    bool isUsable() const;
    // The renderer's name from the driver.
    QString graphicsDevice() const;
    // True for a renderer without a GPU: draw less while things move.
    bool isSoftwareRendered() const;

    // Sets the body, `model` in its own coordinates; null: no body.
    void setBody(std::shared_ptr<const TexturedMesh> model);
    void setBodyTransform(const Eigen::Isometry3d& modelToWorld);
    // One colour for each triangle instead of the texture; empty: the texture.
    void setBodyColours(const std::vector<QRgb>& colours);
    // Lines on the body's surface, drawn over it.
    void setBodyLines(const std::vector<ViewLine>& lines);
    void setBodyVisible(bool visible);
    // Shown in the lower left corner, in this order; empty: none.
    void setLegend(std::vector<ViewLegendEntry> entries);

    // Sets the film. `positions`: x, y, z for each point, taken to the world by setFilmTransform().
    void setFilm(FilmShape shape, std::vector<float> positions);
    void setFilmPositions(std::vector<float> positions); // one for each point of the shape
    void setFilmTransform(const Eigen::Isometry3d& filmToWorld);
    void setFilmPicture(const QImage& picture);     // clears the colours
    void setFilmColours(std::vector<QRgb> colours); // one for each point; empty: the picture
    void setFilmOpacity(double share);              // 1: opaque

    // Cuts body and film open; none: they are whole. Rays then start where something is drawn.
    void setSection(const std::optional<SectionPlane>& section);

    // Draws the tank, and a frame of water around the film. `film`: its floating size; `depth`: of
    // the tank.
    void setTank(QSizeF film, double depth);
    void setWaterVisible(bool visible);

    // The three rings that turn the body, around `centre` (world).
    void setRotationRings(bool visible, const Eigen::Vector3f& centre, double radius);

    // The arrows that move the body along X, Y and Z. They reach from `begin` to `end` mm from
    // `centre` (world).
    void setMoveArrows(const std::array<bool, 3>& visible, const Eigen::Vector3f& centre,
                       double begin, double end);

    // The linked cursor and the measured distance (world); nullopt hides them.
    void setMarker(const std::optional<Eigen::Vector3f>& position);
    void setMeasure(const std::vector<Eigen::Vector3f>& points, const QString& label);

    // Each press of the left button is offered to the callbacks in order until one returns true.
    // The drag is then a stroke and does not move the camera.
    void addStroke(std::function<bool(const ViewRay&)> begins);

    // Camera.
    void setNavigation(Navigation navigation);
    void setParallelProjection(bool parallel);
    void look(ViewDirection direction); // and fits
    // Looks at a place on the body.
    void lookAt(const Eigen::Vector3f& place, const Eigen::Vector3f& outward);
    void fit();
    // Whether fit() shows body and film, or only the body. A camera that was placed by fit() is
    // fitted again.
    void setFilmFitted(bool fitted);
    // Places the camera as in another view, see cameraMoved().
    void setCamera(const ViewCamera& camera);
    void setColours(const ViewColours& colours);
    // In widget coordinates, for the picture that was drawn last.
    ViewRay rayAt(QPointF position) const;
    QPointF positionOf(const Eigen::Vector3f& point) const;

    // The current state at the view's size. Waits until it has been drawn.
    QImage picture();
    const QImage& shownPicture() const; // the last drawn picture; null before the first
    // The drawing time of the last picture, in milliseconds.
    int pictureTime() const;
    // Requests a new picture. Requests during drawing cause only one more picture.
    void requestPicture();

signals:
    void hovered(const dipwright::ViewRay& ray);
    void hoverLeft();
    void clicked(const dipwright::ViewRay& ray); // pressed and released at the same place
    // The right button was pressed and released at the same place, or the menu key was pressed.
    // `place` is on the screen.
    void menuAsked(const dipwright::ViewRay& ray, const QPoint& place);
    void stroked(const dipwright::ViewRay& ray); // at the press and during the stroke
    void strokeFinished();
    void rotationDragged(int axis, double degrees); // since the press, about the world's X, Y or Z
    void rotationFinished();
    void moveDragged(int axis, double millimetres); // since the press, along the world's X, Y or Z
    void moveFinished();
    // A picture was drawn with a camera that was moved in this view, not by setCamera(). So linked
    // views do not answer each other.
    void cameraMoved(const dipwright::ViewCamera& camera);
    void sectionDragged(double place); // mm along its axis

protected:
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
    // Calls `what` on the drawing thread before the next picture.
    void change(std::function<void(ViewScene&)> what);
    void sendMouse(const ViewMouse& mouse);
    void updateSize();
    void draw();
    void take(const ViewPicture& picture);
    void dragRing(const QMouseEvent& event);
    void dragArrow(const QMouseEvent& event);
    bool holdHandle();
    void lightHandles(const QPointF& position);
    void dragSection(const QPointF& position);
    void lightSection(const QPointF& position);
    void paintLegend(QPainter& painter) const;

    std::unique_ptr<State> state_;
};

} // namespace dipwright
