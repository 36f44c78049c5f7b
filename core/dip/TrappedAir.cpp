#include "dip/TrappedAir.h"

#include "dip/TrianglePieces.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

TrappedAir trappedAir(const PosedBody& body) {
    TrappedAir trapped;
    if (body.air.isEmpty()) {
        return trapped;
    }
    const TriangleMesh& mesh = body.mesh;
    std::vector<double> dry(mesh.triangles.size()); // mm² per triangle
    parallelFor(std::size_t(0), dry.size(), [&](std::size_t triangle) {
        const double area = triangleArea(mesh, triangle);
        const int pieces = 1 + int(std::sqrt(area) / double(body.air.cell()));
        int caught = 0;
        forEachPiece(std::uint32_t(triangle), pieces,
                     [&](const SurfacePoint& middle) { caught += body.isDry(middle) ? 1 : 0; });
        dry[triangle] = area * caught / (pieces * pieces);
    });
    for (const double area : dry) {
        trapped.area += area;
    }
    if (!body.path.isStraightDown()) {
        return trapped; // the water's level in the pockets changes while the body turns
    }
    for (const AirPocket& pocket : body.air.all()) {
        const double height = pocket.level - double(boundingBox(mesh).min().y());
        trapped.height = std::min(trapped.height.value_or(height), height);
    }
    return trapped;
}

} // namespace dipwright
