#include "pipeline/TotalCoverage.h"

#include "dip/FilmOnBody.h"
#include "geometry/SurfaceSamples.h"

#include <algorithm>

namespace dipwright {
namespace {

constexpr int samplesOfBody = 40'000;

bool covers(const FilmOnBody& film, const SurfacePoint& point) {
    Eigen::Vector2f rest;
    std::uint32_t triangle = 0;
    return film.locate(point, rest, triangle);
}

} // namespace

double totalCoverage(const std::vector<ImmersionResult>& immersions, const Progress& progress) {
    if (immersions.size() == 1) {
        return immersions.front().coverage->share;
    }
    std::vector<FilmOnBody> films;
    for (const ImmersionResult& immersion : immersions) {
        progress.cancelSwitch.throwIfCancelled();
        films.emplace_back(*immersion.film, *immersion.contact, *immersion.body);
    }
    const TriangleMesh& mesh = immersions.front().body->model.mesh;
    const std::vector<SurfacePoint> samples = evenSamples(mesh, surfaceArea(mesh) / samplesOfBody);
    const auto painted =
        std::count_if(samples.begin(), samples.end(), [&](const SurfacePoint& sample) {
            return std::any_of(films.begin(), films.end(),
                               [&](const FilmOnBody& film) { return covers(film, sample); });
        });
    return double(painted) / double(samples.size());
}

} // namespace dipwright
