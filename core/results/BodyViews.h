// Draws pictures of a body from several sides by ray tracing.
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"
#include "texture/LinearLight.h"

#include <QImage>

#include <functional>

class QPainter;

namespace dipwright {

struct BodyRay {
    Eigen::Vector3f origin, direction;
};

// A camera that looks at the centre of a body.
class BodyCamera {
public:
    // `turn`: radians from the front (0) to the right (π/2) and on. `elevation`: radians over the
    // horizon.
    BodyCamera(const BoundingBox& box, float turn, float elevation);

    // Returns half the height of the view, at unit distance, that shows all of `mesh` in a `tile`.
    float span(const TriangleMesh& mesh, QSize tile) const;
    // Returns the ray through `pixel`, from the upper left corner of a view of that span and size.
    BodyRay ray(QPointF pixel, float span, QSize tile) const;

    bool isBelow() const { return back_.y() < -0.5f; }
    const Eigen::Vector3f& right() const { return right_; }
    const Eigen::Vector3f& up() const { return up_; }

private:
    Eigen::Vector3f middle_, back_, right_, up_;
    float distance_;
};

// Returns cameras at the front, the right, above, the back, the left and below: the order of the
// tiles, three by two. The four sides are seen from `elevation` radians over the horizon.
inline constexpr int sideColumns = 3;
std::vector<BodyCamera> sixSides(const BoundingBox& box, float elevation);
QRect sideBox(int side, QSize tile);

// Returns the span that shows the whole body, with a margin, in each of these cameras.
float commonSpan(const std::vector<BodyCamera>& cameras, const TriangleMesh& mesh, QSize tile);

// Returns the light along a ray; called on many threads.
using RayLight = std::function<LinearColour(const BodyRay&)>;

// Traces a view into a tile of an RGB888 picture. Uses one ray for most pixels and several where
// neighbours differ. All cores; throws Cancelled.
void traceView(QImage& picture, const QRect& tile, const RayLight& light, const BodyCamera& camera,
               float span, const CancelToken& cancelToken);

// Draws the sides' names and lines between the tiles.
void nameSides(QPainter& painter, QSize tile);

} // namespace dipwright
