// Closest-point and ray queries against one mesh, by Embree's bounding-volume hierarchy.
#pragma once

#include "geometry/TriangleMesh.h"

#include <limits>
#include <memory>

namespace dipwright {

struct ClosestPoint {
    SurfacePoint point; // invalid: nothing within the asked distance
    float distance = std::numeric_limits<float>::infinity(); // mm, unsigned
};

struct RayHit {
    SurfacePoint point;                                      // invalid: nothing was hit
    float distance = std::numeric_limits<float>::infinity(); // in units of the direction's length
};

// Built once for a mesh, asked often. Keeps a copy of the mesh, which may go or change afterwards.
// All queries may run on many threads at once and give the same answer in every run.
class SurfaceQuery {
public:
    explicit SurfaceQuery(const TriangleMesh& mesh);
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

    // The surface point nearest to `position`, no farther than `within` mm.
    ClosestPoint closest(const Eigen::Vector3f& position,
                         float within = std::numeric_limits<float>::infinity()) const;
    // The nearest surface point at any distance, looked for first within `likely` mm, which is
    // faster where that was a good guess.
    ClosestPoint closestNear(const Eigen::Vector3f& position, float likely) const;
    // The first hit of the ray from `origin` along `direction`, up to `reach` times its length.
    RayHit hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
               float reach = std::numeric_limits<float>::infinity()) const;
    // Inside or not: most of several rays leave the body more often, or less often, than they enter
    // it. Overlapping parts count as one body, and small holes do not turn the answer round.
    bool isInside(const Eigen::Vector3f& position) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
