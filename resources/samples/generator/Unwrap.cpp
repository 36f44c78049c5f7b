#include "Unwrap.h"

#include <cmath>
#include <stdexcept>

namespace dipwright::samples {

namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

float cross(const Vector2f& a, const Vector2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// A triangle's true shape in the plane, with its centroid at the origin.
struct FlatShape {
    std::array<std::uint32_t, 3> corners;
    std::array<Vector2f, 3> places;
};

FlatShape flatShape(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const Vector3f first = mesh.positions[corners[1]] - mesh.positions[corners[0]];
    const Vector3f second = mesh.positions[corners[2]] - mesh.positions[corners[0]];
    const Vector3f along = first.normalized();
    const float x = second.dot(along);
    const Vector2f b(first.norm(), 0);
    const Vector2f c(x, (second - x * along).norm());
    const Vector2f centroid = (b + c) / 3;
    return {corners, {-centroid, b - centroid, c - centroid}};
}

// Moves the triangle's corners towards its true shape, which is rotated to fit best.
void restoreShape(const FlatShape& shape, std::vector<Vector2f>& flat) {
    const Vector2f centroid =
        (flat[shape.corners[0]] + flat[shape.corners[1]] + flat[shape.corners[2]]) / 3;
    Vector2f turn = Vector2f::Zero(); // cosine and sine, both times the same factor
    for (int i = 0; i < 3; ++i) {
        const Vector2f place = flat[shape.corners[i]] - centroid;
        turn += Vector2f(shape.places[i].dot(place), cross(shape.places[i], place));
    }
    turn.normalize();
    for (int i = 0; i < 3; ++i) {
        const Vector2f& own = shape.places[i];
        const Vector2f goal = centroid + Vector2f(turn.x() * own.x() - turn.y() * own.y(),
                                                  turn.y() * own.x() + turn.x() * own.y());
        flat[shape.corners[i]] += 0.5F * (goal - flat[shape.corners[i]]);
    }
}

bool isFolded(const FlatShape& shape, const std::vector<Vector2f>& flat) {
    const Vector2f& origin = flat[shape.corners[0]];
    return cross(flat[shape.corners[1]] - origin, flat[shape.corners[2]] - origin) <= 0;
}

// Moves the corners of folded triangles to the mean of their neighbours. Returns false if no
// triangle is folded.
bool unfold(const std::vector<FlatShape>& shapes, std::vector<Vector2f>& flat) {
    std::vector<std::uint8_t> isTangled(flat.size(), 0);
    for (const FlatShape& shape : shapes) {
        if (isFolded(shape, flat)) {
            for (const std::uint32_t corner : shape.corners) {
                isTangled[corner] = 1;
            }
        }
    }
    std::vector<Vector2f> sum(flat.size(), Vector2f::Zero());
    std::vector<float> count(flat.size(), 0);
    for (const auto& [corners, places] : shapes) {
        for (int i = 0; i < 3; ++i) {
            sum[corners[i]] += flat[corners[(i + 1) % 3]] + flat[corners[(i + 2) % 3]];
            count[corners[i]] += 2;
        }
    }
    bool found = false;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        if (isTangled[i]) {
            flat[i] = sum[i] / count[i];
            found = true;
        }
    }
    return found;
}

} // namespace

std::vector<Vector2f> unwrap(const TriangleMesh& mesh, const std::vector<std::uint32_t>& piece,
                             std::vector<Vector2f> flat) {
    std::vector<FlatShape> shapes;
    shapes.reserve(piece.size());
    for (const std::uint32_t triangle : piece) {
        shapes.push_back(flatShape(mesh, mesh.triangles[triangle]));
    }
    for (int sweep = 0; sweep < 600; ++sweep) {
        for (const FlatShape& shape : shapes) {
            restoreShape(shape, flat);
        }
        unfold(shapes, flat);
    }
    for (int round = 0; round < 50; ++round) {
        if (!unfold(shapes, flat)) {
            return flat;
        }
    }
    throw std::runtime_error("the surface does not lie flat without folds");
}

} // namespace dipwright::samples
