#include "pipeline/TotalCoverage.h"

#include "dip/FilmOnBody.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double samplesOfBody = 40'000; // at least; a triangle has one or more

// `count` points over a triangle, by the R2 sequence folded into it: even, and always the same.
std::vector<Eigen::Vector3f> spreadWeights(int count) {
    std::vector<Eigen::Vector3f> weights;
    for (int i = 0; i < count; ++i) {
        double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0);
        double v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        weights.emplace_back(float(1 - u - v), float(u), float(v));
    }
    return weights;
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
    const double areaOfSample = surfaceArea(mesh) / samplesOfBody;
    double painted = 0;
    double total = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const double area = triangleArea(mesh, triangle);
        const auto weights = spreadWeights(std::max(1, int(std::lround(area / areaOfSample))));
        const auto hits = std::count_if(weights.begin(), weights.end(), [&](const auto& weight) {
            return std::any_of(films.begin(), films.end(), [&](const FilmOnBody& film) {
                Eigen::Vector2f rest;
                std::uint32_t filmTriangle = 0;
                return film.locate({std::uint32_t(triangle), weight}, rest, filmTriangle);
            });
        });
        painted += area * double(hits) / double(weights.size());
        total += area;
    }
    return painted / total;
}

} // namespace dipwright
