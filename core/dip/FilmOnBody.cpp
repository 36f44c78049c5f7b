#include "dip/FilmOnBody.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Cosine between the film's normal, which points into the body, and the body's outward one: past
// it, the film lies on another side of the body.
constexpr float otherSide = -0.05f;

// Weights up to this count as none: the place is on an edge or in a corner.
constexpr float noWeight = 1e-5f;

} // namespace

struct FilmOnBody::Data {
    const DippedFilm& film;
    const FilmContact& contact;
    const TriangleMesh& body;
    std::vector<std::uint32_t> filmTriangle; // of each painted triangle
    TriangleMesh painted;
    std::vector<std::uint32_t> opposite;     // by painted edge: noEdge at the border
    std::vector<std::uint8_t> isBorderPoint; // a film point each
    SurfaceQuery query;
    float reach;

    Data(const DippedFilm& dipped, const FilmContact& located, const PosedBody& posed,
         std::vector<std::uint32_t> indices, TriangleMesh mesh)
        : film(dipped), contact(located), body(posed.model.mesh), filmTriangle(std::move(indices)),
          painted(std::move(mesh)), opposite(oppositeEdges(painted)),
          isBorderPoint(painted.positions.size(), 0), query(painted),
          reach(float(std::max(dipped.grid.spacingX(), dipped.grid.spacingZ()))) {
        for (std::size_t edge = 0; edge < opposite.size(); ++edge) {
            if (opposite[edge] == noEdge) {
                isBorderPoint[painted.triangles[edge / 3][edge % 3]] = 1;
                isBorderPoint[painted.triangles[edge / 3][(edge + 1) % 3]] = 1;
            }
        }
    }

    bool fits(const SurfacePoint& onFilm, const Eigen::Vector3f& outward) const {
        return onFilm.isValid() &&
               triangleNormal(painted, onFilm.triangle).dot(outward) < otherSide;
    }
    bool isOnBorder(const SurfacePoint& onFilm) const {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t next = (corner + 1) % 3;
            const bool onEdge = onFilm.weights[(corner + 2) % 3] <= noWeight;
            const bool inCorner = onEdge && onFilm.weights[next] <= noWeight;
            if ((onEdge && opposite[3 * onFilm.triangle + corner] == noEdge) ||
                (inCorner && isBorderPoint[painted.triangles[onFilm.triangle][corner]])) {
                return true;
            }
        }
        return false;
    }
    // Whether the film's nearest place is its border, seen from beyond it.
    bool isBeyondBorder(const SurfacePoint& onFilm, const Eigen::Vector3f& offset,
                        const Eigen::Vector3f& outward) const {
        const float sideways = (offset - offset.dot(outward) * outward).norm();
        return sideways > 0.02f * reach && isOnBorder(onFilm);
    }
    // The film on the side of the body where `place` is.
    ClosestPoint filmOver(const Eigen::Vector3f& place, const Eigen::Vector3f& outward) const {
        ClosestPoint nearest = query.closest(place, reach);
        if (fits(nearest.point, outward)) {
            return nearest;
        }
        const RayHit above = query.hit(place, outward, reach);
        const RayHit below = query.hit(place, -outward, reach);
        if (fits(above.point, outward) &&
            (above.distance <= below.distance || !fits(below.point, outward))) {
            return {above.point, above.distance};
        }
        return fits(below.point, outward) ? ClosestPoint{below.point, below.distance}
                                          : ClosestPoint{};
    }
};

FilmOnBody::FilmOnBody(const DippedFilm& film, const FilmContact& contact, const PosedBody& body) {
    const std::vector<FilmTriangle> triangles = filmTriangles(film.grid);
    std::vector<std::uint32_t> indices;
    // On the body itself, should the film have stopped short of it by a contact distance.
    TriangleMesh painted{contact.places, {}};
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.reaches(std::uint32_t(triangle))) {
            indices.push_back(std::uint32_t(triangle));
            painted.triangles.push_back(triangles[triangle]);
        }
    }
    data_ = std::make_unique<Data>(film, contact, body, std::move(indices), std::move(painted));
}

FilmOnBody::~FilmOnBody() = default;
FilmOnBody::FilmOnBody(FilmOnBody&&) noexcept = default;
FilmOnBody& FilmOnBody::operator=(FilmOnBody&&) noexcept = default;

bool FilmOnBody::locate(const SurfacePoint& point, Eigen::Vector2f& rest,
                        std::uint32_t& triangle) const {
    const Eigen::Vector3f place = position(data_->body, point);
    const Eigen::Vector3f outward = triangleNormal(data_->body, point.triangle);
    const ClosestPoint found = data_->filmOver(place, outward);
    if (!found.point.isValid()) {
        return false;
    }
    const Eigen::Vector3f offset = place - position(data_->painted, found.point);
    const bool deepInAHollow = offset.dot(outward) < -float(touchedHollow) * data_->reach;
    if (deepInAHollow || data_->isBeyondBorder(found.point, offset, outward)) {
        return false;
    }
    triangle = data_->filmTriangle[found.point.triangle];
    if (!data_->contact.reaches(triangle, found.point.weights)) {
        return false;
    }
    const FilmTriangle& corners = data_->painted.triangles[found.point.triangle];
    rest.setZero();
    for (int corner = 0; corner < 3; ++corner) {
        rest += found.point.weights[corner] *
                restPosition(data_->film.grid, corners[std::size_t(corner)]);
    }
    return true;
}

} // namespace dipwright
