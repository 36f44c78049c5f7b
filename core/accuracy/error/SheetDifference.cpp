#include "accuracy/error/SheetDifference.h"

#include <algorithm>
#include <limits>

namespace dipwright {
namespace {

std::vector<SurfacePoint> middlesOf(const RefinedMesh& fine) {
    std::vector<SurfacePoint> middles;
    for (std::size_t piece = 0; piece < fine.mesh().triangles.size(); ++piece) {
        middles.push_back(fine.middle(piece));
    }
    return middles;
}

SurfacePoint farthestOf(const std::vector<SurfacePoint>& places, const std::vector<float>& moves) {
    const auto most = std::max_element(moves.begin(), moves.end());
    return most != moves.end() && *most >= 0 ? places[std::size_t(most - moves.begin())]
                                             : SurfacePoint();
}

} // namespace

std::vector<float> pointMoves(const LaidFilm& own, const LaidFilm& other) {
    std::vector<float> distances = sheetMoves(own, other, own.contact().surface);
    for (float& distance : distances) {
        distance = distance == paintedByOne ? std::numeric_limits<float>::quiet_NaN()
                                            : std::max(distance, 0.f);
    }
    return distances;
}

SheetDifference sheetDifference(const LaidFilm& first, const LaidFilm& second,
                                const RefinedMesh& fine) {
    const std::vector<SurfacePoint> places = comparedPlaces(second.body());
    const std::vector<float> moves = sheetMoves(first, second, places);
    return {sheetMoves(first, second, middlesOf(fine)), pointMoves(second, first),
            sheetChange(moves), farthestOf(places, moves)};
}

} // namespace dipwright
