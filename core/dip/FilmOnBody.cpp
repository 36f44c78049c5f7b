#include "dip/FilmOnBody.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Film lies on another side of the body if the cosine between its normal and the body's outward
// normal is larger than this. The film's normal points into the body.
constexpr float otherSide = -0.05f;

// Barycentric weights up to this count as zero; the place is then on an edge or in a corner.
constexpr float noWeight = 1e-5f;

// Share of reach_ that is searched first. Film on the body is usually that close, and a short
// search is faster.
constexpr float close = 0.1f;

std::vector<std::uint32_t> reachedTriangles(const FilmContact& contact) {
    std::vector<std::uint32_t> reached;
    for (std::uint32_t triangle = 0; triangle < contact.painted.size(); ++triangle) {
        if (contact.reaches(triangle)) {
            reached.push_back(triangle);
        }
    }
    return reached;
}

// Returns a mesh of the film that paints. It uses the places on the body, since film points may
// stop one contact distance before the body.
TriangleMesh paintedMesh(const FilmContact& contact, const std::vector<FilmTriangle>& triangles,
                         const std::vector<std::uint32_t>& reached) {
    TriangleMesh painted{contact.places, {}};
    for (const std::uint32_t triangle : reached) {
        painted.triangles.push_back(triangles[triangle]);
    }
    return painted;
}

std::vector<Eigen::Vector3f> triangleNormals(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3f> normals;
    normals.reserve(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        normals.push_back(triangleNormal(mesh, triangle));
    }
    return normals;
}

float largestCell(const solver::FilmGrid& grid, const std::vector<std::uint32_t>& triangles) {
    float largest = 0;
    for (const std::uint32_t triangle : triangles) {
        largest = std::max(largest, cellOfTriangle(grid, triangle));
    }
    return largest;
}

} // namespace

FilmOnBody::FilmOnBody(const solver::FilmGrid& grid, const std::vector<FilmTriangle>& triangles,
                       const FilmContact& contact, const TriangleMesh& body)
    : grid_(grid), contact_(contact), body_(body), filmTriangle_(reachedTriangles(contact)),
      painted_(paintedMesh(contact, triangles, filmTriangle_)), bodyNormals_(triangleNormals(body)),
      paintedNormals_(triangleNormals(painted_)), opposite_(oppositeEdges(painted_)),
      isBorderPoint_(painted_.positions.size(), 0), query_(painted_),
      reach_(largestCell(grid, filmTriangle_)), near_(body.triangles.size()) {
    for (std::size_t edge = 0; edge < opposite_.size(); ++edge) {
        if (opposite_[edge] == noEdge) {
            isBorderPoint_[painted_.triangles[edge / 3][edge % 3]] = 1;
            isBorderPoint_[painted_.triangles[edge / 3][(edge + 1) % 3]] = 1;
        }
    }
}

float FilmOnBody::cell(const SurfacePoint& onFilm) const {
    return cellOfTriangle(grid_, filmTriangle_[onFilm.triangle]);
}

// Whether film covers a place of the body that is `distance` away.
bool FilmOnBody::fits(const SurfacePoint& onFilm, float distance,
                      const Eigen::Vector3f& outward) const {
    return onFilm.isValid() && distance <= cell(onFilm) &&
           paintedNormals_[onFilm.triangle].dot(outward) < otherSide;
}

bool FilmOnBody::isOnBorder(const SurfacePoint& onFilm) const {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t next = (corner + 1) % 3;
        const bool onEdge = onFilm.weights[(corner + 2) % 3] <= noWeight;
        const bool inCorner = onEdge && onFilm.weights[next] <= noWeight;
        if ((onEdge && opposite_[3 * onFilm.triangle + corner] == noEdge) ||
            (inCorner && isBorderPoint_[painted_.triangles[onFilm.triangle][corner]])) {
            return true;
        }
    }
    return false;
}

// Whether the nearest place of the film is on the film's border and the queried place is beyond it.
bool FilmOnBody::isBeyondBorder(const SurfacePoint& onFilm, const Eigen::Vector3f& offset,
                                const Eigen::Vector3f& outward) const {
    const float sideways = (offset - offset.dot(outward) * outward).norm();
    return sideways > 0.02f * cell(onFilm) && isOnBorder(onFilm);
}

// Finds the film on the same side of the body as `place`.
ClosestPoint FilmOnBody::filmOver(const Eigen::Vector3f& place,
                                  const Eigen::Vector3f& outward) const {
    const ClosestPoint nearest = query_.closestNear(place, close * reach_, reach_);
    if (fits(nearest.point, nearest.distance, outward)) {
        return nearest;
    }
    const RayHit above = query_.hit(place, outward, reach_);
    const RayHit below = query_.hit(place, -outward, reach_);
    const bool isAbove = fits(above.point, above.distance, outward);
    const bool isBelow = fits(below.point, below.distance, outward);
    if (isAbove && (above.distance <= below.distance || !isBelow)) {
        return {above.point, above.distance};
    }
    return isBelow ? ClosestPoint{below.point, below.distance} : ClosestPoint{};
}

// Whether film is at most about reach_ away from a triangle of the body.
bool FilmOnBody::isNear(std::uint32_t triangle) const {
    const Near known = near_[triangle].load(std::memory_order_relaxed);
    if (known != Near::Unknown) {
        return known == Near::Yes;
    }
    const auto& [a, b, c] = body_.triangles[triangle];
    const Eigen::Vector3f middle =
        (body_.positions[a] + body_.positions[b] + body_.positions[c]) / 3;
    const float radius =
        std::max({(body_.positions[a] - middle).norm(), (body_.positions[b] - middle).norm(),
                  (body_.positions[c] - middle).norm()});
    const bool found = query_.isNear(middle, 1.01f * (reach_ + radius));
    near_[triangle].store(found ? Near::Yes : Near::No, std::memory_order_relaxed);
    return found;
}

std::optional<FilmPlace> FilmOnBody::place(const SurfacePoint& point) const {
    if (!isNear(point.triangle)) {
        return std::nullopt;
    }
    const Eigen::Vector3f onBody = position(body_, point);
    const Eigen::Vector3f& outward = bodyNormals_[point.triangle];
    const ClosestPoint found = filmOver(onBody, outward);
    if (!found.point.isValid()) {
        return std::nullopt;
    }
    const Eigen::Vector3f offset = onBody - position(painted_, found.point);
    const bool deepInAHollow = offset.dot(outward) < -float(touchedHollow) * cell(found.point);
    if (deepInAHollow || isBeyondBorder(found.point, offset, outward)) {
        return std::nullopt;
    }
    FilmPlace place;
    place.triangle = filmTriangle_[found.point.triangle];
    if (!contact_.reaches(place.triangle, found.point.weights)) {
        return std::nullopt;
    }
    const FilmTriangle& corners = painted_.triangles[found.point.triangle];
    for (int corner = 0; corner < 3; ++corner) {
        place.rest +=
            found.point.weights[corner] * restPosition(grid_, corners[std::size_t(corner)]);
    }
    return place;
}

} // namespace dipwright
