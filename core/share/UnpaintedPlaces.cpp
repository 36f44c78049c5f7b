#include "share/UnpaintedPlaces.h"

#include "geometry/SurfacePieces.h"
#include "marks/SurfaceMask.h"
#include "parallel/ParallelFor.h"

namespace dipwright {
namespace {

constexpr double leastListedArea = 1; // mm²; smaller places are not listed

} // namespace

std::vector<UnpaintedPlace> unpaintedPlaces(const BodyShare& share, const PosedBody& body,
                                            const SurfaceMask* mask) {
    const RefinedMesh& fine = *share.fade.mesh;
    std::vector<std::uint8_t> unpainted(share.painters.size());
    parallelFor(std::size_t(0), unpainted.size(), [&](std::size_t triangle) {
        const SurfacePoint middle = fine.middle(std::uint32_t(triangle));
        unpainted[triangle] = share.painters[triangle] == Painter::None &&
                              !(mask && mask->covers(middle)) && !body.isBuried(middle);
    });
    const auto isUnpainted = [&](std::uint32_t triangle) { return unpainted[triangle] != 0; };
    std::vector<UnpaintedPlace> places;
    for (const SurfacePiece& piece :
         surfacePieces(fine.mesh(), oppositeEdges(fine.mesh()), isUnpainted, leastListedArea)) {
        places.push_back({piece.area, position(fine.mesh(), middleOf(piece.middle))});
    }
    return places;
}

} // namespace dipwright
