#include "dip/Coverage.h"

#include "dip/TrappedAir.h"
#include "dip/TrianglePieces.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double samplesPerFilmCell = 4;
constexpr int mostPieces = 64; // a triangle's samples are at most the square of this
constexpr int samplesOfBody = 40'000;

} // namespace

Coverage coverage(const LaidFilm& laid) {
    const TriangleMesh& mesh = laid.body().model.mesh;
    const solver::FilmGrid& grid = laid.film().grid;
    const double sampleArea = grid.leastSpacingX() * grid.leastSpacingZ() / samplesPerFilmCell;
    std::vector<double> painted(mesh.triangles.size(), 0);
    Coverage result;
    result.covered.assign(mesh.triangles.size(), 0);
    parallelFor(std::size_t(0), mesh.triangles.size(), [&](std::size_t triangle) {
        const double area = triangleArea(mesh, triangle);
        const int pieces =
            int(std::clamp(std::ceil(std::sqrt(area / sampleArea)), 1.0, double(mostPieces)));
        int hits = 0;
        forEachPiece(std::uint32_t(triangle), pieces,
                     [&](const SurfacePoint& sample) { hits += laid.place(sample) ? 1 : 0; });
        painted[triangle] = area * hits / (pieces * pieces);
        result.covered[triangle] = 2 * hits >= pieces * pieces ? 1 : 0;
    });
    for (const double area : painted) {
        result.paintedArea += area;
    }
    result.share = result.paintedArea / surfaceArea(mesh);
    result.trappedAirArea = trappedAirArea(laid.body());
    return result;
}

double coverageTogether(const std::vector<std::shared_ptr<const LaidFilm>>& films,
                        const Progress& progress) {
    const TriangleMesh& mesh = films.front()->body().model.mesh;
    const std::vector<SurfacePoint> samples = evenSamples(mesh, surfaceArea(mesh) / samplesOfBody);
    std::vector<std::uint8_t> painted(samples.size());
    parallelFor(std::size_t(0), samples.size(), [&](std::size_t sample) {
        progress.cancelSwitch.throwIfCancelled();
        painted[sample] = std::any_of(films.begin(), films.end(), [&](const auto& laid) {
            return laid->place(samples[sample]).has_value();
        });
    });
    return double(std::count(painted.begin(), painted.end(), 1)) / double(samples.size());
}

} // namespace dipwright
