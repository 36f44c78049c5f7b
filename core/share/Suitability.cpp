#include "share/Suitability.h"

#include "parallel/ParallelFor.h"
#include "texture/Ink.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

// Chosen costs of 1 mm² (docs/film-model.md, "Two dips, one body").
constexpr float notReached = 20;
constexpr float pastStretchLimit = 10;
constexpr float marked = 2;
constexpr float tooPale = 1;
// Where the film's area has doubled; added again for every further doubling.
constexpr float doubledArea = 0.5f;
constexpr float upwards = 1; // on faces that face straight up; half of it on upright faces

float costThere(const LaidFilm& laid, const FilmPlace& place, const LinearColour& colour,
                double stretchLimit, const InkCompensation& ink) {
    const PrincipalStretch& stretch = laid.stretches()[place.triangle];
    float cost = laid.marks(place.triangle) != 0 ? marked : 0;
    cost += stretch.larger > float(stretchLimit) ? pastStretchLimit : 0;
    cost += ink.print(ink.toned(colour), stretch.area()).fallsShort ? tooPale : 0;
    cost += doubledArea * std::log2(std::max(stretch.area(), 1.0f));
    return cost;
}

} // namespace

Suitability suitability(const RefinedMesh& body, const LaidFilm& laid,
                        const std::vector<LinearColour>& colours, double stretchLimit,
                        const InkSettings& ink) {
    const std::size_t triangles = body.mesh().triangles.size();
    const InkCompensation compensation(ink);
    Suitability result{std::vector<std::uint8_t>(triangles), std::vector<float>(triangles, 1.0f),
                       std::vector<float>(triangles)};
    parallelFor(std::size_t(0), triangles, [&](std::size_t triangle) {
        const SurfacePoint middle = body.middle(triangle);
        const Eigen::Vector3f normal = triangleNormal(laid.body().mesh, middle.triangle);
        const std::optional<FilmPlace> place = laid.place(middle);
        result.reached[triangle] = place ? 1 : 0;
        result.stretch[triangle] = place ? laid.stretches()[place->triangle].larger : 1;
        result.cost[triangle] =
            place ? upwards * (1 + normal.y()) / 2 +
                        costThere(laid, *place, colours[triangle], stretchLimit, compensation)
                  : notReached;
    });
    return result;
}

} // namespace dipwright
