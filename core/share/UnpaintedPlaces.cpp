#include "share/UnpaintedPlaces.h"

#include "geometry/SurfacePieces.h"
#include "marks/SurfaceMask.h"

namespace dipwright {
namespace {

constexpr double leastListedArea = 1; // mm²; smaller places are not listed

} // namespace

std::vector<UnpaintedPlace> unpaintedPlaces(const BodyShare& share, const SurfaceMask* mask) {
    const RefinedMesh& fine = *share.fade.mesh;
    const auto isUnpainted = [&](std::uint32_t triangle) {
        return share.painters[triangle] == Painter::None &&
               !(mask && mask->covers(fine.middle(triangle)));
    };
    std::vector<UnpaintedPlace> places;
    for (const SurfacePiece& piece :
         surfacePieces(fine.mesh(), oppositeEdges(fine.mesh()), isUnpainted, leastListedArea)) {
        places.push_back({piece.area, position(fine.mesh(), middleOf(piece.middle))});
    }
    return places;
}

} // namespace dipwright
