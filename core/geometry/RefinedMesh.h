// A mesh cut finer, without cracks, that still knows the triangles it came from.
#pragma once

#include "geometry/TriangleMesh.h"

#include <functional>
#include <memory>

namespace dipwright {

// The longest edge, mm, with which about so many triangles of one size cover a mesh.
float edgeForTriangles(const TriangleMesh& mesh, double triangles);

// Immutable once it is made; any thread may read.
class RefinedMesh {
public:
    // Cuts the edges of `coarse` at their middles until none is longer than `longestEdge` (> 0),
    // mm. Triangles on both sides of an edge cut it alike.
    RefinedMesh(const TriangleMesh& coarse, float longestEdge);
    // Cuts those that are too long by their ends, again and again: the answer may depend on where
    // they lie and must become no for short ones.
    using TooLong = std::function<bool(const Eigen::Vector3f& from, const Eigen::Vector3f& to)>;
    RefinedMesh(const TriangleMesh& coarse, const TooLong& isTooLong);

    // The first positions are those of the coarse mesh.
    const TriangleMesh& mesh() const { return mesh_; }
    // The middle of a fine triangle, as a place of the coarse mesh.
    SurfacePoint middle(std::size_t triangle) const;
    // A place of a fine triangle, by its corners' weights, as one of the coarse mesh.
    SurfacePoint onCoarse(const SurfacePoint& fine) const;
    // The fine triangle round a place of the coarse mesh, and the place's weights in it.
    SurfacePoint onFine(const SurfacePoint& coarse) const;

private:
    // Barycentric weights in the coarse triangle, as columns for the three corners.
    using Corners = Eigen::Matrix3f;
    // A triangle, or the part of one that was cut again.
    struct Part {
        Corners corners;
        std::uint32_t first = 0; // the parts it was cut into; of a whole one: its fine triangle
        std::uint32_t count = 0; // 0: was not cut
    };

    TriangleMesh mesh_;
    std::vector<std::uint32_t> parents_;   // the coarse triangle that each fine one is part of
    std::vector<Part> parts_;              // the coarse triangles first
    std::vector<std::uint32_t> fineParts_; // a fine triangle each
};

// Numbers at the positions of a refined mesh, linear in between: a field on the surface that can be
// asked at places of the coarse mesh.
struct SurfaceField {
    std::shared_ptr<const RefinedMesh> mesh;
    std::vector<float> values; // a position each

    float at(const SurfacePoint& coarse) const;
};

} // namespace dipwright
