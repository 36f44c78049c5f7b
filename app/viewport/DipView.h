// The 3D view of a dip: body, film, water and tank, with camera, handles and rays under the cursor.
//
// World frame: millimetres, right-handed, Y up, the waterline is the plane y = 0. The view shows
// what it is given and decides nothing; it knows no project and no solver. UI thread only.
//
// The pictures are drawn on a thread of its own: however long one takes, the window does not wait.
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

// While Shift is held, rings turn and arrows move the body by steps of this.
inline constexpr double ringStep = 15; // degrees
inline constexpr double arrowStep = 5; // mm

// How dragging with the left button turns the camera.
enum class Navigation {
    Turntable, // the world's Y axis stays upright
    Trackball, // freely
};

enum class ViewDirection { Front, Back, Left, Right, Top, Bottom, Oblique };

// The topology of the film as drawn; `texture` holds (u to the right, v down the sheet, 0 … 1) a
// point. A triangle with a side longer than `longestSide` (mm) is not drawn: it is torn, or hangs
// between film that has been let go of and film on the body.
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

// What one of the body's colours means.
struct ViewLegendEntry {
    QColor colour;
    QString text;
};

class DipView : public QWidget {
    Q_OBJECT

public:
    explicit DipView(QWidget* parent = nullptr);
    ~DipView() override;

    // False where no OpenGL 3.2 context could be made; `graphicsDevice` then says why.
    bool isUsable() const;
    // The renderer's name as the driver gives it.
    QString graphicsDevice() const;
    // A renderer without a GPU: draw less while things move.
    bool isSoftwareRendered() const;

    // Body. `model` in its own coordinates; null: nothing to show.
    void setBody(std::shared_ptr<const TexturedMesh> model);
    void setBodyTransform(const Eigen::Isometry3d& modelToWorld);
    // A colour a triangle instead of the texture; empty: the texture.
    void setBodyColours(const std::vector<QRgb>& colours);
    // Drawn over the surface that they lie in.
    void setBodyLines(const std::vector<ViewLine>& lines);
    void setBodyVisible(bool visible);
    // In the lower left corner, in this order; empty: none.
    void setLegend(std::vector<ViewLegendEntry> entries);

    // Film. Positions: x, y, z a point; the transform takes them to the world.
    void setFilm(FilmShape shape, std::vector<float> positions);
    void setFilmPositions(std::vector<float> positions); // as many as the shape has points
    void setFilmTransform(const Eigen::Isometry3d& filmToWorld);
    void setFilmPicture(const QImage& picture);     // clears colours
    void setFilmColours(std::vector<QRgb> colours); // a point each; empty: the picture
    void setFilmOpacity(double share);              // 1: the body is not seen through it

    // Cuts body and film open; none: they are whole. Rays begin where something is drawn.
    void setSection(const std::optional<SectionPlane>& section);

    // Tank and water: a frame of water round the film, `film` its floating size, `depth` of the
    // tank.
    void setTank(QSizeF film, double depth);
    void setWaterVisible(bool visible);

    // The three rings that turn the body, round `centre` (world).
    void setRotationRings(bool visible, const Eigen::Vector3f& centre, double radius);

    // The arrows that move the body along X, Y and Z, from `begin` to `end` mm from `centre`
    // (world).
    void setMoveArrows(const std::array<bool, 3>& visible, const Eigen::Vector3f& centre,
                       double begin, double end);

    // The linked cursor and the measured distance (world); nullopt hides them.
    void setMarker(const std::optional<Eigen::Vector3f>& position);
    void setMeasure(const std::vector<Eigen::Vector3f>& points, const QString& label);

    // Asked of a press of the left button, one after the other until one says yes: whether the drag
    // that follows is a stroke, which leaves the camera alone.
    void addStroke(std::function<bool(const ViewRay&)> begins);

    // Camera.
    void setNavigation(Navigation navigation);
    void setParallelProjection(bool parallel);
    void look(ViewDirection direction);                                        // and fit
    void lookAt(const Eigen::Vector3f& place, const Eigen::Vector3f& outward); // at the body
    void fit();
    // Whether fit() makes room for the film, too, or for the body alone. A camera that stands where
    // fit() has put it is fitted anew.
    void setFilmFitted(bool fitted);
    // Where the camera of another view stands, see cameraMoved().
    void setCamera(const ViewCamera& camera);
    void setColours(const ViewColours& colours);
    // In widget coordinates, as the picture that was drawn last shows the world.
    ViewRay rayAt(QPointF position) const;
    QPointF positionOf(const Eigen::Vector3f& point) const;

    // What the view is to show, at its own size: waits until it has been drawn.
    QImage picture();
    const QImage& shownPicture() const; // the one drawn last; null before the first
    // How long drawing it took, in milliseconds.
    int pictureTime() const;
    // Asks for a new picture; many requests on the way of one make one more.
    void requestPicture();

signals:
    void hovered(const dipwright::ViewRay& ray);
    void hoverLeft();
    void clicked(const dipwright::ViewRay& ray); // pressed and released in the same place
    // The right button pressed and released in the same place, or the menu's key; a place on the
    // screen.
    void menuAsked(const dipwright::ViewRay& ray, const QPoint& place);
    void stroked(const dipwright::ViewRay& ray); // where a stroke is pressed and moves along
    void strokeFinished();
    void rotationDragged(int axis, double degrees); // about the world's X, Y or Z since the press
    void rotationFinished();
    void moveDragged(int axis, double millimetres); // along the world's X, Y or Z since the press
    void moveFinished();
    // A picture was drawn by a camera that was moved here, not by setCamera(): views that follow
    // each other do not answer each other.
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
    // Has it done on the drawing thread, before the next picture.
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
