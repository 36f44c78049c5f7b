#include "geometry/BuriedSurface.h"

#include "geometry/FieldGrid.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"
#include "parallel/Tasks.h"

#include <algorithm>
#include <cstdint>
#include <mutex>

namespace dipwright {
namespace {

constexpr double wantedSamples = 20'000;

double buriedShare(const TriangleMesh& mesh, const SurfaceQuery& query) {
    const std::vector<SurfacePoint> places = evenSamples(mesh, surfaceArea(mesh) / wantedSamples);
    std::vector<std::uint8_t> buried(places.size());
    parallelFor(std::size_t(0), places.size(),
                [&](std::size_t i) { buried[i] = isBuried(places[i], mesh, query) ? 1 : 0; });
    const double share = double(std::count(buried.begin(), buried.end(), std::uint8_t(1))) /
                         double(std::max<std::size_t>(places.size(), 1));
    return share < leastBuriedShare ? 0 : share;
}

} // namespace

struct BuriedSurface::Share {
    std::once_flag isKnown;
    double value = 0;
};

std::shared_ptr<BuriedSurface::Share> BuriedSurface::makeShare() {
    return std::make_shared<Share>();
}

double BuriedSurface::share(const TriangleMesh& mesh, const SurfaceQuery& query) const {
    // Isolated: otherwise this thread might take up work that waits for this share.
    std::call_once(share_->isKnown,
                   [&] { runIsolated([&] { share_->value = buriedShare(mesh, query); }); });
    return share_->value;
}

bool BuriedSurface::covers(const SurfacePoint& place, const TriangleMesh& mesh,
                           const SurfaceQuery& query) const {
    return share(mesh, query) > 0 && isBuried(place, mesh, query);
}

bool isBuried(const SurfacePoint& place, const TriangleMesh& mesh, const SurfaceQuery& query) {
    const Eigen::Vector3f outward = triangleNormal(mesh, place.triangle);
    const Eigen::Vector3f inFront = position(mesh, place) + buriedReach * outward;
    // Most places see the open, which one ray tells.
    return query.isHit(inFront, outward) && query.isBehind(inFront);
}

std::vector<std::uint8_t> buriedPlaces(const TriangleMesh& model,
                                       const std::vector<SurfacePoint>& places) {
    const TriangleMesh body = inBodyCoordinates(model); // floats near the origin are exact enough
    const SurfaceQuery query(body);
    std::vector<std::uint8_t> buried(places.size());
    if (const BuriedSurface surface; surface.share(body, query) > 0) {
        parallelFor(std::size_t(0), places.size(),
                    [&](std::size_t i) { buried[i] = isBuried(places[i], body, query) ? 1 : 0; });
    }
    return buried;
}

} // namespace dipwright
