// Closest-point and ray queries on one mesh, by Embree's bounding-volume hierarchy.
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

// Built once for a mesh and queried often. Keeps a copy of the mesh. Queries are thread-safe and
// give the same answer in every run.
class SurfaceQuery {
public:
    explicit SurfaceQuery(const TriangleMesh& mesh);
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

    // Returns the surface point nearest to `position`, at most `within` mm away.
    ClosestPoint closest(const Eigen::Vector3f& position,
                         float within = std::numeric_limits<float>::infinity()) const;
    // Returns the nearest surface point at any distance. Searches within `likely` mm first, which
    // is faster if that was a good guess.
    ClosestPoint closestNear(const Eigen::Vector3f& position, float likely) const;
    // Returns the first hit of the ray from `origin` along `direction`, up to `reach` times its
    // length.
    RayHit hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
               float reach = std::numeric_limits<float>::infinity()) const;
    // Whether `position` is inside: for most of several rays the exits and entries do not balance.
    // Overlapping parts count as one body, and small holes do not change the answer.
    bool isInside(const Eigen::Vector3f& position) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
