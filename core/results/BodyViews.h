// Draws pictures of a body from several sides.
#pragma once

#include "base/Progress.h"
#include "results/SeenBody.h"
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
    // `turn` is the camera's direction in radians: 0 is the front, π/2 the right. `elevation` is
    // the angle over the horizon in radians.
    BodyCamera(const BoundingBox& box, float turn, float elevation);

    // Returns the span of a view that shows all of `mesh` in a `tile`. The span is half the view's
    // height at unit distance from the camera.
    float span(const TriangleMesh& mesh, QSize tile) const;
    // Returns the ray through `pixel`, which counts from the upper left corner of a view of the
    // given span and size.
    BodyRay ray(QPointF pixel, float span, QSize tile) const;
    // Returns what a view of the given span and size shows of `mesh`, with several sample points in
    // each pixel (middleOf() is one of them). Uses all cores.
    SeenBody see(const TriangleMesh& mesh, float span, QSize tile) const;

    bool isBelow() const { return back_.y() < -0.5f; }
    const Eigen::Vector3f& right() const { return right_; }
    const Eigen::Vector3f& up() const { return up_; }

private:
    Eigen::Vector3f middle_, back_, right_, up_;
    float distance_;
};

// Returns six cameras in the order of the tiles, three by two: front, right, above, back, left,
// below. The cameras of the four sides stand `elevation` radians over the horizon.
inline constexpr int sideColumns = 3;
std::vector<BodyCamera> sixSides(const BoundingBox& box, float elevation);
QRect sideBox(int side, QSize tile);

// Returns the span with which each of these cameras shows the whole body with a margin.
float commonSpan(const std::vector<BodyCamera>& cameras, const TriangleMesh& mesh, QSize tile);

// A function that returns the light along a ray and the place of the body that the ray meets first
// (invalid: none). It is called on many threads.
using RayLight = std::function<LinearColour(const BodyRay&, const SurfacePoint&)>;

// Returns the place that `body`, from BodyCamera::see(), shows in the middle of a pixel.
SurfacePoint middleOf(const SeenBody& body, int x, int y);

// Draws a view into a tile of an RGB888 picture. `body` is from BodyCamera::see() of the same view.
// Uses one sample for most pixels and several where neighbours differ. Uses all cores. Throws
// Cancelled.
void drawView(QImage& picture, const QRect& tile, const SeenBody& body, const RayLight& light,
              const BodyCamera& camera, float span, const CancelToken& cancelToken);

// Draws the sides' names and lines between the tiles.
void nameSides(QPainter& painter, QSize tile);

} // namespace dipwright
