#include "texture/ReadBack.h"

#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"
#include "texture/ReverseMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

constexpr double wantedSamples = 20000;
constexpr double mostSamples = 400000; // limit for the whole body, if little of it is painted
constexpr int borderCells = 2;

// Tells for each film cell, by row and column, whether it and all cells within `borderCells` are
// painted.
std::vector<std::uint8_t> cellsWellInside(const solver::FilmGrid& grid,
                                          const FilmContact& contact) {
    const int columns = grid.columns - 1;
    const int rows = grid.rows - 1;
    const auto painted = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= columns || row >= rows) {
            return false;
        }
        const std::size_t cell = std::size_t(row) * std::size_t(columns) + std::size_t(column);
        return contact.painted[2 * cell] && contact.painted[2 * cell + 1];
    };
    std::vector<std::uint8_t> inside;
    inside.reserve(std::size_t(columns) * std::size_t(rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            bool all = true;
            for (int down = -borderCells; down <= borderCells; ++down) {
                for (int right = -borderCells; right <= borderCells; ++right) {
                    all = all && painted(column + right, row + down);
                }
            }
            inside.push_back(all ? 1 : 0);
        }
    }
    return inside;
}

double paintedArea(const LaidFilm& laid) {
    double area = 0;
    for (std::size_t triangle = 0; triangle < laid.triangles().size(); ++triangle) {
        if (laid.contact().painted[triangle]) {
            area +=
                double(laid.stretches()[triangle].area()) * restArea(laid.film().grid, triangle);
        }
    }
    return area;
}

// Returns the distance on the body, in mm, between `wanted` and the place to which the colour at
// `wanted` belongs.
float errorAt(const TriangleMesh& body, const std::vector<std::uint32_t>& chart,
              const ReverseMap& map, const SurfacePoint& wanted, const FilmWeights& place) {
    const Eigen::Vector3f at = position(body, wanted);
    const SurfacePoint carried = map.surface(place);
    const TexturePlace shown = map.texture(place);
    float error = std::numeric_limits<float>::infinity();
    // Try both nearby triangles, because a triangle with almost no area on the texture gives no
    // distance on the body.
    for (const std::uint32_t triangle : {carried.triangle, shown.bodyTriangle}) {
        const auto belongs = map.showing(shown.coordinate, triangle);
        if (belongs && chart[triangle] == chart[shown.bodyTriangle]) {
            error = std::min(error, (*belongs - at).norm());
        }
    }
    return std::isfinite(error) ? error : (position(body, carried) - at).norm();
}

} // namespace

ReadBackError readBackError(const LaidFilm& planned, const LaidFilm& laid,
                            const SurfaceAppearance& appearance) {
    const TriangleMesh& body = planned.body().mesh;
    const double whole = surfaceArea(body);
    const double painted = paintedArea(planned);
    if (!(painted > 0)) {
        return {};
    }
    const std::vector<SurfacePoint> samples =
        evenSamples(body, std::max(painted / wantedSamples, whole / mostSamples));
    const std::vector<std::uint8_t> inside =
        cellsWellInside(planned.film().grid, planned.contact());
    const ReverseMap map(planned, appearance);
    constexpr float leftOut = -1;
    std::vector<float> errors(samples.size(), leftOut);
    parallelFor(std::size_t(0), samples.size(), [&](std::size_t sample) {
        const std::optional<FilmPlace> place = laid.place(samples[sample]);
        if (place && inside[place->triangle / 2]) {
            errors[sample] = errorAt(body, appearance.chart, map, samples[sample],
                                     {place->triangle, planned.weights(*place)});
        }
    });
    std::erase(errors, leftOut);
    const Distribution spread = distribution(errors);
    return {spread.mean, spread.percentile95, spread.maximum, errors.size()};
}

} // namespace dipwright
