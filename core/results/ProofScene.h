// Prepares a body on a light table for ray tracing: ray queries, normals and ambient light.
#pragma once

#include "geometry/CornerNormals.h"
#include "geometry/SurfaceQuery.h"

namespace dipwright {

// The visible share of the sky, 0 … 1, at each position of a mesh (ambient occlusion) and on the
// table below it. Computed once by rays on all cores; any thread may read it.
class SkyLight {
public:
    SkyLight(const TriangleMesh& mesh, const SurfaceQuery& query);

    float onBody(const SurfacePoint& point) const;
    // Returns the share at x and z on the table, y = tableHeight().
    float onTable(float x, float z) const;
    float tableHeight() const { return tableHeight_; }

private:
    static constexpr int tableCells = 96;

    const TriangleMesh& mesh_;
    std::vector<float> body_; // of each position
    float tableHeight_ = 0;
    Eigen::Vector2f tableOrigin_ = Eigen::Vector2f::Zero();
    float tableSpacing_ = 1;
    std::vector<float> table_; // (tableCells + 1)², rows along x
};

// The body with all that ray tracing needs. Keeps a reference to the mesh.
struct ProofStage {
    explicit ProofStage(const TriangleMesh& body)
        : mesh(body), query(body), normals(cornerNormals(body)), sky(body, query),
          box(boundingBox(body)) {}

    const TriangleMesh& mesh;
    SurfaceQuery query;
    CornerNormals normals;
    SkyLight sky;
    BoundingBox box;
};

} // namespace dipwright
