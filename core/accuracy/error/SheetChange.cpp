#include "accuracy/error/SheetChange.h"

#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

#include <algorithm>

namespace dipwright {
namespace {

constexpr double wantedSamples = 40'000; // number of points on the body

float move(const LaidFilm& own, const LaidFilm& other, const SurfacePoint& place) {
    const auto before = own.place(place);
    const auto after = other.place(place);
    return before && after   ? (after->rest - before->rest).norm()
           : before || after ? paintedByOne
                             : paintedByNeither;
}

} // namespace

bool isAccurateEnough(const SheetChange& change, double mostDistance) {
    return change.painted > 0 && change.distance.percentile95 <= mostDistance &&
           change.paintedOnce <= mostPaintedOnce;
}

std::vector<SurfacePoint> comparedPlaces(const PosedBody& body) {
    std::vector<SurfacePoint> places =
        evenSamples(body.mesh, surfaceArea(body.mesh) / wantedSamples);
    std::erase_if(places, [&](const SurfacePoint& place) { return body.isBuried(place); });
    return places;
}

std::vector<float> sheetMoves(const LaidFilm& own, const LaidFilm& other,
                              const std::vector<SurfacePoint>& places) {
    std::vector<float> moves(places.size(), paintedByNeither);
    parallelFor(std::size_t(0), places.size(), [&](std::size_t i) {
        if (places[i].isValid()) {
            moves[i] = move(own, other, places[i]);
        }
    });
    return moves;
}

std::vector<float> unmarkedMoves(std::vector<float> moves, const LaidFilm& own,
                                 const std::vector<SurfacePoint>& places) {
    parallelFor(std::size_t(0), places.size(), [&](std::size_t i) {
        const auto place = moves[i] == paintedByNeither ? std::nullopt : own.place(places[i]);
        if (place && own.marks(place->triangle) != 0) {
            moves[i] = paintedByNeither;
        }
    });
    return moves;
}

SheetChange sheetChange(std::vector<float> moves) {
    const auto all = double(moves.size());
    SheetChange result;
    result.paintedOnce = double(std::count(moves.begin(), moves.end(), paintedByOne)) / all;
    std::erase_if(moves, [](float distance) { return distance < 0; });
    result.painted = double(moves.size()) / all;
    result.distance = distribution(std::move(moves));
    return result;
}

} // namespace dipwright
