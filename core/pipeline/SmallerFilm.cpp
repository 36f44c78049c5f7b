#include "pipeline/SmallerFilm.h"

#include "project/FilmSizes.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

// Returns the part of the printed film that a dip needs, in mm from the film's centre.
Eigen::AlignedBox2d neededFilm(const ImmersionResult& dip, const FilmSettings& film) {
    Eigen::AlignedBox2d needed = usedFilm(*dip.laid).cast<double>();
    const BoundingBox body = boundingBox(dip.body->mesh);
    const Eigen::Vector2d offset(dip.immersion.offset[0].value(), dip.immersion.offset[1].value());
    needed.extend(offset + Eigen::Vector2d(body.min().x(), body.min().z()));
    needed.extend(offset + Eigen::Vector2d(body.max().x(), body.max().z()));
    const Eigen::Vector2d swell(film.swellX, film.swellY);
    return {needed.min().cwiseQuotient(swell), needed.max().cwiseQuotient(swell)};
}

// Whether the film is too small as it is placed. What a film would need is not known then.
bool reachesEdge(const ImmersionResult& dip) {
    return std::any_of(
        dip.verdict.reasons.begin(), dip.verdict.reasons.end(),
        [](const VerdictReason& reason) { return reason.kind == VerdictReason::Kind::FilmEdge; });
}

bool isHeld(const FilmEdges& edges) {
    return edges.leftPinned || edges.rightPinned || edges.topPinned || edges.bottomPinned;
}

} // namespace

double filmUsed(const JobResult& result) {
    double most = 0;
    for (const ImmersionResult& dip : result.immersions) {
        most = std::max(most, usedShare(*dip.laid));
    }
    return most;
}

std::optional<SmallerFilm> smallerFilm(const JobResult& result) {
    const FilmSettings& film = result.project.film;
    const auto isUnknown = [](const ImmersionResult& dip) {
        return !dip.body->path.isStraightDown() || reachesEdge(dip);
    };
    if (isHeld(film.edges) ||
        std::any_of(result.immersions.begin(), result.immersions.end(), isUnknown)) {
        return std::nullopt;
    }
    SmallerFilm found;
    Eigen::Vector2d needed(0, 0);
    for (const ImmersionResult& dip : result.immersions) {
        const Eigen::AlignedBox2d box = neededFilm(dip, film);
        needed = needed.cwiseMax(box.sizes());
        // The centre is rounded to whole mm. The rim leaves room for that.
        const Eigen::Vector2d middle = box.center();
        found.moves.push_back({Millimetres(-std::round(middle.x() * film.swellX)),
                               Millimetres(-std::round(middle.y() * film.swellY))});
    }
    needed.array() += 2 * freeRim.value();
    double least = mostAreaShare * film.width.value() * film.height.value();
    for (const QString& format : filmSizeNames()) {
        const QSizeF upright = filmSize(format);
        for (const QSizeF size : {upright, upright.transposed()}) {
            const double area = size.width() * size.height();
            if (area < least && size.width() >= needed.x() && size.height() >= needed.y()) {
                least = area;
                found.format = format;
                found.width = Millimetres(size.width());
                found.height = Millimetres(size.height());
            }
        }
    }
    return found.format.isEmpty() ? std::nullopt : std::optional(found);
}

void take(Project& project, const SmallerFilm& film) {
    resizeFilm(project.film, film.width, film.height);
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            Millimetres& offset = project.immersions[number].offset[axis];
            offset = offset + film.moves[number][axis];
        }
    }
}

} // namespace dipwright
