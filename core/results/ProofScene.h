// Prepares a body on a light table for ray tracing: ray queries, normals and ambient light.
#pragma once

#include "geometry/CornerNormals.h"
#include "geometry/SurfaceQuery.h"

namespace dipwright {

// The visible share of the sky, 0 … 1, at each position of a mesh (ambient occlusion) and on the
// table below the mesh. The constructor computes it by rays on all cores. Any thread may read it.
class SkyLight {
public:
    SkyLight(const TriangleMesh& mesh, const SurfaceQuery& query);

    float onBody(const SurfacePoint& point) const;
    // Returns the visible share of the sky at x and z on the table.
    float onTable(float x, float z) const;
    // Returns the y of the table.
    float tableHeight() const { return tableHeight_; }

private:
    static constexpr int tableCells = 96;

    const TriangleMesh& mesh_;
    std::vector<float> body_; // share at each position of the mesh
    float tableHeight_ = 0;
    Eigen::Vector2f tableOrigin_ = Eigen::Vector2f::Zero();
    float tableSpacing_ = 1;
    std::vector<float> table_; // shares at (tableCells + 1)² points, rows along x
};

// A body with everything that ray tracing needs. Keeps a reference to the mesh.
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
