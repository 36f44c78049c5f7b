#include "dip/Coverage.h"

#include "dip/FilmOnBody.h"
#include "dip/TrappedAir.h"
#include "dip/TrianglePieces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double samplesPerFilmCell = 4;
constexpr int mostPieces = 64; // a triangle's samples are at most the square of this

} // namespace

Coverage coverage(const DippedFilm& film, const FilmContact& contact, const PosedBody& body,
                  const SurfaceQuery& query) {
    const TriangleMesh& mesh = body.model.mesh;
    const FilmOnBody filmOnBody(film, contact, body);
    const double sampleArea = film.grid.spacingX() * film.grid.spacingZ() / samplesPerFilmCell;
    std::vector<double> painted(mesh.triangles.size(), 0);
    Coverage result;
    result.covered.assign(mesh.triangles.size(), 0);
    tbb::parallel_for(std::size_t(0), mesh.triangles.size(), [&](std::size_t triangle) {
        const double area = triangleArea(mesh, triangle);
        const int pieces =
            int(std::clamp(std::ceil(std::sqrt(area / sampleArea)), 1.0, double(mostPieces)));
        int hits = 0;
        forEachPiece(std::uint32_t(triangle), pieces, [&](const SurfacePoint& sample) {
            Eigen::Vector2f rest;
            std::uint32_t filmTriangle = 0;
            hits += filmOnBody.locate(sample, rest, filmTriangle) ? 1 : 0;
        });
        painted[triangle] = area * hits / (pieces * pieces);
        result.covered[triangle] = 2 * hits >= pieces * pieces ? 1 : 0;
    });
    for (const double area : painted) {
        result.paintedArea += area;
    }
    result.share = result.paintedArea / surfaceArea(mesh);
    result.trappedAirArea = trappedAirArea(body, query);
    return result;
}

} // namespace dipwright
