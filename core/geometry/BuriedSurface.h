// Finds the surface of a body that lies inside the body, as where parts of a model overlap or
// touch. No film reaches it, and nobody sees it, so it counts neither as painted nor as bare
// (docs/film-validation.md, "The verdict").
#pragma once

#include "geometry/SurfaceQuery.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace dipwright {

// A place is buried if the point this far in front of its face is inside the body, mm. So surfaces
// that face each other across a narrower gap are buried, too.
inline constexpr float buriedReach = 0.02f;
// If less than this share of the surface is buried, nothing counts as buried: scans have tiny
// folds.
inline constexpr double leastBuriedShare = 0.0005;

// Tells which places of one body are buried. All functions need the body's mesh and its query, in
// any pose. The first call samples the whole surface, on all cores; threads that call meanwhile
// wait. Any thread may use it. Deterministic.
class BuriedSurface {
public:
    // Returns the buried share of the surface; 0 if it is too small to count.
    double share(const TriangleMesh& mesh, const SurfaceQuery& query) const;
    bool covers(const SurfacePoint& place, const TriangleMesh& mesh,
                const SurfaceQuery& query) const;

private:
    struct Share;
    std::shared_ptr<Share> share_ = makeShare();
    static std::shared_ptr<Share> makeShare();
};

// Whether a place is buried, however small the buried share is.
bool isBuried(const SurfacePoint& place, const TriangleMesh& mesh, const SurfaceQuery& query);

// Returns which places of a model are buried (1), computed on all cores. The model may lie far from
// its origin.
std::vector<std::uint8_t> buriedPlaces(const TriangleMesh& model,
                                       const std::vector<SurfacePoint>& places);

} // namespace dipwright
