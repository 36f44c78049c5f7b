// Closest-point and ray queries on one mesh, by Embree's bounding-volume hierarchy.
#pragma once

#include "geometry/TriangleMesh.h"

#include <limits>
#include <memory>

namespace dipwright {

struct ClosestPoint {
    SurfacePoint point; // invalid if no surface is within the requested distance
    float distance = std::numeric_limits<float>::infinity(); // mm, unsigned
};

struct RayHit {
    SurfacePoint point;                                      // invalid if the ray hits nothing
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
    // The same; searches within `likely` mm first, which is faster if the point is that near.
    ClosestPoint closestNear(const Eigen::Vector3f& position, float likely,
                             float within = std::numeric_limits<float>::infinity()) const;
    // Whether closest() finds a point.
    bool isNear(const Eigen::Vector3f& position, float within) const;
    // Returns the triangles near a place, in ascending order: all that come within `distance` mm of
    // it, and possibly a few others.
    std::vector<std::uint32_t> trianglesNear(const Eigen::Vector3f& position, float distance) const;
    // Returns the first hit of the ray from `origin` along `direction`, up to `reach` times the
    // direction's length.
    RayHit hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
               float reach = std::numeric_limits<float>::infinity()) const;
    // Whether hit() finds a hit.
    bool isHit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
               float reach = std::numeric_limits<float>::infinity()) const;
    // Returns the distances of all hits of the same ray, nearest first. On an edge, each of its
    // triangles counts.
    std::vector<float> allHits(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                               float reach) const;
    // Whether `position` is inside: most of several rays from it have different numbers of exits
    // and entries. Overlapping parts count as one body, and small holes do not change the answer.
    bool isInside(const Eigen::Vector3f& position) const;
    // Whether `position` is behind the surface: most of the same rays have more exits than entries.
    // Unlike isInside(), this is false in front of an open surface, whose back no ray hits.
    bool isBehind(const Eigen::Vector3f& position) const;

private:
    // Whether `counts` is true for the exits minus the entries of most of several rays.
    bool holdsForMost(const Eigen::Vector3f& position, bool (*counts)(int winding)) const;

    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
