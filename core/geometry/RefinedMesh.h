// A refined mesh without cracks, which maps places to and from the coarse mesh it was made of.
#pragma once

#include "geometry/TriangleMesh.h"

#include <functional>
#include <memory>

namespace dipwright {

// Returns the edge length, in mm, at which about `triangles` triangles of equal size cover the
// mesh.
float edgeForTriangles(const TriangleMesh& mesh, double triangles);

// Immutable after construction; any thread may read.
class RefinedMesh {
public:
    // Bisects the edges of `coarse` until none is longer than `longestEdge` (> 0), mm. Both
    // triangles of an edge are cut at the same point.
    RefinedMesh(const TriangleMesh& coarse, float longestEdge);
    // Bisects each edge for which `isTooLong` returns true. The result may depend on the positions
    // of the edge's ends, but must be false for short edges.
    using TooLong = std::function<bool(const Eigen::Vector3f& from, const Eigen::Vector3f& to)>;
    RefinedMesh(const TriangleMesh& coarse, const TooLong& isTooLong);

    // The refined mesh. It begins with the positions of the coarse mesh.
    const TriangleMesh& mesh() const { return mesh_; }
    // Returns the middle of a fine triangle as a place on the coarse mesh.
    SurfacePoint middle(std::size_t triangle) const;
    // Converts a place on the fine mesh to one on the coarse mesh.
    SurfacePoint onCoarse(const SurfacePoint& fine) const;
    // Converts a place on the coarse mesh to one on the fine mesh.
    SurfacePoint onFine(const SurfacePoint& coarse) const;

private:
    // Barycentric weights in the coarse triangle, one column for each of the three corners.
    using Corners = Eigen::Matrix3f;
    // A coarse triangle, or a part of one that may be cut again.
    struct Part {
        Corners corners;
        // Index of its first part, or of its fine triangle if it is not cut.
        std::uint32_t first = 0;
        std::uint32_t count = 0; // number of parts; 0 if it is not cut
    };

    TriangleMesh mesh_;
    std::vector<std::uint32_t> parents_;   // coarse triangle of each fine triangle
    std::vector<Part> parts_;              // the coarse triangles come first
    std::vector<std::uint32_t> fineParts_; // index into parts_ for each fine triangle
};

// Refines a body to about 40,000 triangles for work on its surface, such as splitting it between
// dips and drawing it. A body with more triangles is kept as it is.
std::shared_ptr<const RefinedMesh> fineBody(const TriangleMesh& body);
// Returns the longest edge of fineBody(), mm, if the body was refined.
float fineEdge(const TriangleMesh& body);

// A field on the surface: values at the positions of a refined mesh, linear in between. It can be
// evaluated at places on the coarse mesh.
struct SurfaceField {
    std::shared_ptr<const RefinedMesh> mesh;
    std::vector<float> values; // one for each position

    float at(const SurfacePoint& coarse) const { return atFine(mesh->onFine(coarse)); }
    float atFine(const SurfacePoint& fine) const;
};

} // namespace dipwright
