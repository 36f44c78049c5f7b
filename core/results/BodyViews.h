// Pictures of a body from several sides, traced by rays.
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

// Looks at a body's middle from a side.
class BodyCamera {
public:
    // `turn`: radians from the front (0) to the right (a quarter turn) and on; `elevation`: of the
    // camera over the horizon.
    BodyCamera(const BoundingBox& box, float turn, float elevation);

    // Half the height of the view, at unit distance, that shows all of `mesh` in a `tile`.
    float span(const TriangleMesh& mesh, QSize tile) const;
    // Through a place of a view of that span and size, in pixels from its upper left corner.
    BodyRay ray(QPointF pixel, float span, QSize tile) const;

    bool isBelow() const { return back_.y() < -0.5f; }
    const Eigen::Vector3f& right() const { return right_; }
    const Eigen::Vector3f& up() const { return up_; }

private:
    Eigen::Vector3f middle_, back_, right_, up_;
    float distance_;
};

// From the front, the right, above, the back, the left and below, as they stand three by two in
// pictures; the four sides from `elevation` radians over the horizon.
inline constexpr int sideColumns = 3;
std::vector<BodyCamera> sixSides(const BoundingBox& box, float elevation);
QRect sideBox(int side, QSize tile);

// The span with which all of the body is seen from each of these, with air round it.
float commonSpan(const std::vector<BodyCamera>& cameras, const TriangleMesh& mesh, QSize tile);

// The light that comes along a ray; asked on many threads.
using RayLight = std::function<LinearColour(const BodyRay&)>;

// Fills a tile of an RGB888 picture. Most pixels show light that hardly changes: one ray tells
// theirs, and only where neighbours differ a pixel is worth many. All cores; throws Cancelled.
void traceView(QImage& picture, const QRect& tile, const RayLight& light, const BodyCamera& camera,
               float span, const CancelToken& cancelToken);

// The sides' names, and lines between them.
void nameSides(QPainter& painter, QSize tile);

} // namespace dipwright
