#include "dip/FilmThatPaints.h"

#include "dip/ContactLimit.h"
#include "geometry/CornerNormals.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Film spans a hollow if the middle of its edge is farther outside the body than this share of the
// edge's length. A longer edge does not make a hollow shallower.
constexpr float spannedHollow = 0.15f;
// The middle of a painted film triangle is closer to the surface than this share of the triangle's
// longest edge. At this limit the film would pass through the body.
constexpr float cutEdge = 0.5f;
// Least ratio of a film triangle's doubled area to its longest edge squared. Below it, the film is
// folded so flat that its normal is unknown.
constexpr float flat = 1e-3f;
// In cells: film closer to the body than this touches it, even under an air pocket.
constexpr float touching = 0.05f;
// In cells: film that is closer than this below an air pocket's level floats under the pocket. In a
// displaced dip, film may float that far below the level computed for the nominal pose.
constexpr float underAir = 2;
// Cosines between outward normals.
constexpr float turnedAway = 0.1f; // least value between painted film and the face that it lies on
constexpr float foldedAcross = -0.9f; // least value between two faces under one film triangle

// Whether film floats on the water under an air pocket. There is then air above it before any
// surface.
bool isUnderAir(const Eigen::Vector3f& position, const PosedBody& body, float cell) {
    for (const AirPocket& pocket : body.air.all()) {
        const float below = std::max(float(pocket.level) - position.y(), 0.f);
        const Eigen::Vector3f up = (below + float(touchedHollow) * cell) * Eigen::Vector3f::UnitY();
        if (below < underAir * cell && body.air.at(position + up, body.query) == &pocket &&
            !body.query.isHit(position, up, 1)) {
            return true;
        }
    }
    return false;
}

// Returns the place on the body of a film point that the solver reports as touching. The point may
// be a contact distance away from the body. Invalid if the point touches an air pocket.
SurfacePoint surfacePoint(const Eigen::Vector3f& position, const Eigen::Vector3f& filmNormal,
                          const PosedBody& body, float cell) {
    const SurfaceQuery& query = body.query;
    const ClosestPoint closest = query.closestNear(position, touching * cell);
    if (!body.air.isEmpty() && closest.distance > touching * cell &&
        isUnderAir(position, body, cell)) {
        return {};
    }
    // A ray along a slanting normal may miss the surface that the film touches.
    const float reach = 2 * closest.distance + 0.005f * cell;
    const RayHit below = query.hit(position, filmNormal, reach);
    const RayHit above = query.hit(position, -filmNormal, reach);
    const RayHit& along = below.distance <= above.distance ? below : above;
    const SurfacePoint found = along.point.isValid() ? along.point : closest.point;
    return body.isDry(found) ? SurfacePoint{} : found;
}

// Returns the place midway between the four neighbours of a point that missed the body. Invalid
// unless all four are on the body.
SurfacePoint filledPoint(const DippedFilm& film, const PosedBody& body,
                         const std::vector<SurfacePoint>& located, std::size_t point) {
    const auto columns = std::size_t(film.grid.columns);
    const std::size_t column = point % columns;
    const std::size_t row = point / columns;
    const bool inside =
        column > 0 && column + 1 < columns && row > 0 && row + 1 < std::size_t(film.grid.rows);
    if (!inside || film.states[point] == solver::PointState::Trapped) {
        return {};
    }
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    for (const std::size_t neighbour : {point - 1, point + 1, point - columns, point + columns}) {
        if (!located[neighbour].isValid()) {
            return {};
        }
        middle += position(body.mesh, located[neighbour]) / 4;
    }
    const SurfacePoint filled = body.query.closest(middle, cellOfPoint(film.grid, point)).point;
    return filled.isValid() && body.isDry(filled) ? SurfacePoint{} : filled;
}

std::vector<SurfacePoint> locatePoints(const DippedFilm& film, const PosedBody& body) {
    const std::vector<Eigen::Vector3f> normals =
        vertexNormals(TriangleMesh{film.positions, filmTriangles(film.grid)});
    std::vector<SurfacePoint> points(film.positions.size());
    parallelFor(std::size_t(0), points.size(), [&](std::size_t point) {
        if (film.adhered(point)) {
            points[point] = surfacePoint(film.positions[point], normals[point], body,
                                         cellOfPoint(film.grid, point));
        }
    });
    return points;
}

class PaintTest {
public:
    PaintTest(const PosedBody& body, const CornerNormals& normals,
              const std::vector<SurfacePoint>& surface, const ProcessSettings& process)
        : mesh_(body.mesh), path_(body.path), normals_(normals), query_(body.query),
          surface_(surface), steepest_(float(std::sin(radians(process.overhang)))) {}

    // `cell` is the size of the film cell that contains the triangle, mm.
    bool isPainted(const FilmTriangle& triangle, float cell) const {
        return std::all_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t point) { return surface_[point].isValid(); }) &&
               !isFoldedAcross(triangle) && isOnSurface(triangle, float(touchedHollow) * cell);
    }

private:
    Eigen::Vector3f bodyNormal(std::uint32_t point) const {
        return triangleNormal(mesh_, surface_[point].triangle);
    }
    bool isFoldedAcross(const FilmTriangle& triangle) const {
        const std::array<Eigen::Vector3f, 3> normals = {
            bodyNormal(triangle[0]), bodyNormal(triangle[1]), bodyNormal(triangle[2])};
        return normals[0].dot(normals[1]) < foldedAcross ||
               normals[1].dot(normals[2]) < foldedAcross ||
               normals[2].dot(normals[0]) < foldedAcross;
    }
    bool isOnSurface(const FilmTriangle& triangle, float deepest) const {
        const Eigen::Vector3f a = position(mesh_, surface_[triangle[0]]);
        const Eigen::Vector3f b = position(mesh_, surface_[triangle[1]]);
        const Eigen::Vector3f c = position(mesh_, surface_[triangle[2]]);
        const Eigen::Vector3f turn = (b - a).cross(c - a);
        const float longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        if (turn.norm() < flat * longest * longest) {
            return false;
        }
        // The ink side faces up before the dip and lies against the body after it, so the normal
        // points into the body.
        const Eigen::Vector3f intoBody = turn.normalized();
        const Eigen::Vector3f middle = (a + b + c) / 3;
        const ClosestPoint under =
            query_.closestNear(middle, spannedHollow * longest, cutEdge * longest);
        if (!under.point.isValid()) {
            return false;
        }
        const Eigen::Vector3f outward = triangleNormal(mesh_, under.point.triangle);
        return outward.dot(intoBody) < -turnedAway && upwards(under.point) <= steepest_ &&
               !spansHollow((a + b + c) / 3, intoBody, longest, deepest) &&
               !spansHollow((a + b) / 2, intoBody, (b - a).norm(), deepest) &&
               !spansHollow((b + c) / 2, intoBody, (c - b).norm(), deepest) &&
               !spansHollow((c + a) / 2, intoBody, (a - c).norm(), deepest);
    }
    // Returns the vertical component of the body's normal when the place went under water.
    float upwards(const SurfacePoint& place) const {
        const Eigen::Vector3f outward = normalAt(normals_, place);
        return path_.isStraightDown()
                   ? outward.y()
                   : outward.dot(
                         upAtWater(path_, position(mesh_, place).cast<double>()).cast<float>());
    }
    // Whether film spans a hollow at `place`, a mean of two or three places on the body that are
    // `length` apart. Film spans one if `place` is farther outside the body than `deepest` or than
    // spannedHollow · `length`.
    bool spansHollow(const Eigen::Vector3f& place, const Eigen::Vector3f& intoBody, float length,
                     float deepest) const {
        if (query_.isNear(place, std::min(spannedHollow * length, deepest))) {
            return false;
        }
        const ClosestPoint under = query_.closest(place, length);
        return under.point.isValid() && (position(mesh_, under.point) - place).dot(intoBody) > 0;
    }

    const TriangleMesh& mesh_;
    const solver::BodyPath& path_;
    const CornerNormals& normals_;
    const SurfaceQuery& query_;
    const std::vector<SurfacePoint>& surface_;
    float steepest_;
};

} // namespace

FilmContact findFilmContact(const DippedFilm& film, const PosedBody& body,
                            const ProcessSettings& process) {
    FilmContact contact;
    const std::vector<SurfacePoint> located = locatePoints(film, body);
    contact.surface = located;
    for (std::size_t point = 0; point < located.size(); ++point) {
        if (located[point].isValid()) {
            ++contact.contactCount;
            continue;
        }
        contact.surface[point] = filledPoint(film, body, located, point);
        contact.filledCount += contact.surface[point].isValid() ? 1 : 0;
    }

    const std::vector<FilmTriangle> triangles = filmTriangles(film.grid);
    const std::vector<PrincipalStretch> stretches = principalStretches(film);
    const CornerNormals normals = cornerNormals(body.mesh);
    const PaintTest test(body, normals, contact.surface, process);
    contact.painted.resize(triangles.size());
    parallelFor(std::size_t(0), triangles.size(), [&](std::size_t triangle) {
        const bool torn = stretches[triangle].isTorn(process.tearStretch);
        contact.painted[triangle] =
            !torn && test.isPainted(triangles[triangle], cellOfTriangle(film.grid, triangle));
    });
    contact.places = film.positions;
    for (std::size_t point = 0; point < contact.places.size(); ++point) {
        if (contact.surface[point].isValid()) {
            contact.places[point] = position(body.mesh, contact.surface[point]);
        }
    }
    if (film.isotropic) {
        continueToLimit(film, body, normals, process, contact);
    }
    return contact;
}

} // namespace dipwright
