// The 3D view of a dip: body, film, water and tank, with camera, handles and rays under the cursor.
//
// World frame: millimetres, right-handed, Y up, the waterline is the plane y = 0. The view shows
// what it is given and decides nothing; it knows no project and no solver. UI thread only.
#pragma once

#include "model/TexturedMesh.h"

#include <Eigen/Geometry>
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class QKeyEvent;
class QMouseEvent;

namespace dipwright {

// How dragging with the left button turns the camera.
enum class Navigation {
    Turntable, // the world's Y axis stays upright
    Trackball, // freely
};

enum class ViewDirection { Front, Back, Left, Right, Top, Bottom, Oblique };

// What lies under the cursor: from the camera through the pixel, world frame.
struct ViewRay {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    Eigen::Vector3f direction = -Eigen::Vector3f::UnitY(); // unit length
};

// The topology of the film as drawn; `texture` holds (u to the right, v down the sheet, 0 … 1) a
// point.
struct FilmShape {
    std::vector<Eigen::Vector2f> texture;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct ViewColours {
    QColor top, bottom; // background gradient
    QColor ink;         // lines and labels
    QColor accent;      // handles and cursor
    QColor water;
};

class DipView : public QWidget {
    Q_OBJECT

public:
    explicit DipView(QWidget* parent = nullptr);
    ~DipView() override;

    // To be called once before the application object is made: the surface that VTK draws on.
    static void prepareSurfaceFormat();
    // False where no OpenGL 3.2 context could be made; `graphicsDevice` then says why.
    bool isUsable() const;
    // The renderer's name as the driver gives it. Meaningful after the first picture.
    QString graphicsDevice() const;
    // A renderer without a GPU: draw less while things move.
    bool isSoftwareRendered() const;

    // Body. `model` in its own coordinates; null: nothing to show.
    void setBody(std::shared_ptr<const TexturedMesh> model);
    void setBodyTransform(const Eigen::Isometry3d& modelToWorld);
    // A colour a triangle instead of the texture; empty: the texture.
    void setBodyColours(const std::vector<QRgb>& colours);
    void setBodyVisible(bool visible);

    // Film. Positions: x, y, z a point; the transform takes them to the world.
    void setFilm(const FilmShape& shape, std::span<const float> positions);
    void setFilmPositions(std::span<const float> positions); // as many as the shape has points
    void setFilmTransform(const Eigen::Isometry3d& filmToWorld);
    void setFilmPicture(const QImage& picture);            // clears colours
    void setFilmColours(const std::vector<QRgb>& colours); // a point each; empty: the picture
    void setFilmVisible(bool visible);

    // Tank and water: a frame of water round the film, `film` its floating size, `depth` of the
    // tank.
    void setTank(QSizeF film, double depth);
    void setWaterVisible(bool visible);

    // The three rings that turn the body, round `centre` (world).
    void setRotationRings(bool visible, const Eigen::Vector3f& centre, double radius);

    // The linked cursor and the measured distance (world); nullopt hides them.
    void setMarker(const std::optional<Eigen::Vector3f>& position);
    void setMeasure(const std::vector<Eigen::Vector3f>& points, const QString& label);

    // Camera.
    void setNavigation(Navigation navigation);
    void setParallelProjection(bool parallel);
    bool isParallelProjection() const;
    void look(ViewDirection direction); // and fit
    void fit();
    void setColours(const ViewColours& colours);
    ViewRay rayAt(QPointF position) const;                  // widget coordinates
    QPointF positionOf(const Eigen::Vector3f& point) const; // world to widget coordinates

    // What the view shows, at its own size; renders first.
    QImage picture();
    // How long drawing the last one took, in milliseconds.
    int pictureTime() const;
    // Asks for a new picture; many requests before the event loop turns make one picture.
    void requestPicture();

signals:
    void hovered(const dipwright::ViewRay& ray);
    void hoverLeft();
    void clicked(const dipwright::ViewRay& ray);    // pressed and released in the same place
    void rotationDragged(int axis, double degrees); // about the world's X, Y or Z since the press
    void rotationFinished();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Scene;
    bool mousePressed(QMouseEvent* event);
    bool mouseMoved(QMouseEvent* event);
    bool mouseReleased(QMouseEvent* event);
    bool keyPressed(QKeyEvent* event);
    void render();

    std::unique_ptr<Scene> scene_;
};

} // namespace dipwright
