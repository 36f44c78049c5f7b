#include "ImplicitSurface.h"
#include "Painting.h"
#include "Samples.h"
#include "TurtlePaint.h"
#include "TurtleShape.h"
#include "Unwrap.h"

namespace dipwright::samples {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

using Piece = std::vector<std::uint32_t>; // indices of triangles
// Texture coordinates of each triangle's corners.
using Coordinates = std::vector<std::array<Vector2f, 3>>;

// Returns the triangles above and below the outline. `level` holds the positions before the turtle
// is bent.
std::array<Piece, 2> halves(const TriangleMesh& mesh, const std::vector<Vector3f>& level) {
    std::array<Piece, 2> pieces;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        float height = 0;
        for (const std::uint32_t corner : mesh.triangles[t]) {
            height += level[corner].y();
        }
        pieces[height > 0 ? 0 : 1].push_back(t);
    }
    return pieces;
}

// Flattens one half, with the head up, as seen from outside. Seen from below, left and right are
// swapped.
std::vector<Vector2f> flatHalf(const TriangleMesh& mesh, const Piece& piece, bool fromAbove) {
    std::vector<Vector2f> plan;
    plan.reserve(mesh.positions.size());
    for (const Vector3f& place : mesh.positions) {
        plan.emplace_back(fromAbove ? -place.x() : place.x(), place.z());
    }
    return unwrap(mesh, piece, std::move(plan));
}

Eigen::AlignedBox2f extent(const TriangleMesh& mesh, const Piece& piece,
                           const std::vector<Vector2f>& flat) {
    Eigen::AlignedBox2f box;
    for (const std::uint32_t t : piece) {
        for (const std::uint32_t corner : mesh.triangles[t]) {
            box.extend(flat[corner]);
        }
    }
    return box;
}

// Places both halves side by side in the picture at the same scale.
Coordinates turtleCoordinates(const TriangleMesh& mesh, const std::array<Piece, 2>& pieces) {
    constexpr float margin = 3; // mm
    Coordinates result(mesh.triangles.size());
    Vector2f corner(margin, margin);
    float tallest = 0;
    for (std::size_t half = 0; half < pieces.size(); ++half) {
        const std::vector<Vector2f> flat = flatHalf(mesh, pieces[half], half == 0);
        const Eigen::AlignedBox2f box = extent(mesh, pieces[half], flat);
        for (const std::uint32_t t : pieces[half]) {
            for (int i = 0; i < 3; ++i) {
                result[t][i] = flat[mesh.triangles[t][i]] - box.min() + corner;
            }
        }
        corner.x() += box.sizes().x() + margin;
        tallest = std::max(tallest, box.sizes().y() + 2 * margin);
    }
    const float side = std::max(corner.x(), tallest);
    for (auto& corners : result) {
        for (Vector2f& place : corners) {
            place /= side;
        }
    }
    return result;
}

} // namespace

TexturedMesh turtle() {
    TriangleMesh mesh =
        surfaceMesh(turtleField, {Vector3f(-50, -16, -62), Vector3f(50, 29, 66)}, 1.0F);
    mesh = cutAtGround(std::move(mesh), 0.3F);
    const std::vector<Vector3f> level = mesh.positions;
    const Vector3f size = boundingBox(mesh).sizes();
    for (Vector3f& place : mesh.positions) {
        place.y() += lift(place);
        place = place.cwiseProduct(Vector3f(75 / size.x(), 1, 110 / size.z()));
    }
    Coordinates coordinates = turtleCoordinates(mesh, halves(mesh, level));
    const QImage texture = bakeTexture(mesh, coordinates, level, turtleColour);
    return textured(std::move(mesh), std::move(coordinates), texture);
}

} // namespace dipwright::samples
