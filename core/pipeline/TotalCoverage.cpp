#include "pipeline/TotalCoverage.h"

#include "dip/FilmOnBody.h"
#include "pipeline/SurfaceSamples.h"

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
    double painted = 0;
    double total = 0;
    for (const SurfaceSample& sample :
         spreadOverSurface(immersions.front().body->model.mesh, samplesOfBody)) {
        total += sample.area;
        if (std::any_of(films.begin(), films.end(),
                        [&](const FilmOnBody& film) { return covers(film, sample.point); })) {
            painted += sample.area;
        }
    }
    return painted / total;
}

} // namespace dipwright
