// Prepares a body on a light table for pictures: its fine mesh, normals and ambient light.
#pragma once

#include "geometry/CornerNormals.h"
#include "geometry/RefinedMesh.h"
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

// A body with everything that pictures of it need. Keeps a reference to the mesh.
struct ProofStage {
    ProofStage(const TriangleMesh& body, std::shared_ptr<const RefinedMesh> refined)
        : mesh(body), fine(std::move(refined)), query(body), normals(cornerNormals(body)),
          sky(body, query), box(boundingBox(body)) {}

    const TriangleMesh& mesh;
    std::shared_ptr<const RefinedMesh> fine; // of `mesh`
    SurfaceQuery query;
    CornerNormals normals;
    SkyLight sky;
    BoundingBox box;
};

} // namespace dipwright
