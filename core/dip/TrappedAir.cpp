#include "dip/TrappedAir.h"

#include "dip/TrianglePieces.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

TrappedAir trappedAir(const PosedBody& body) {
    TrappedAir trapped;
    if (body.air.isEmpty()) {
        return trapped;
    }
    const TriangleMesh& mesh = body.mesh;
    std::vector<double> dry(mesh.triangles.size()); // mm² per triangle
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> cutOff(dry.size(), never); // distance travelled, mm; only on a path
    const bool isOnPath = !body.path.isStraightDown();
    parallelFor(std::size_t(0), dry.size(), [&](std::size_t triangle) {
        const double area = triangleArea(mesh, triangle);
        const int pieces = 1 + int(std::sqrt(area) / double(body.air.cell()));
        int caught = 0;
        forEachPiece(std::uint32_t(triangle), pieces, [&](const SurfacePoint& middle) {
            if (!body.isDry(middle)) {
                return;
            }
            ++caught;
            if (isOnPath) {
                const auto way = firstUnderWater(body.path, position(mesh, middle).cast<double>());
                cutOff[triangle] = std::min(cutOff[triangle], way.value_or(never));
            }
        });
        dry[triangle] = area * caught / (pieces * pieces);
    });
    for (const double area : dry) {
        trapped.area += area;
    }
    double first = never;
    if (isOnPath) { // the water's level in the pockets changes while the body turns
        for (const double way : cutOff) {
            first = std::min(first, way);
        }
    } else {
        for (const AirPocket& pocket : body.air.all()) {
            first =
                std::min(first, startHeight + pocket.level - double(boundingBox(mesh).min().y()));
        }
    }
    if (first < never) {
        trapped.travelled = first;
    }
    return trapped;
}

} // namespace dipwright
