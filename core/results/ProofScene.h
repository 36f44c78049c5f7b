// A body on a light table, ready to be looked at: what a ray meets, and the light there.
#pragma once

#include "geometry/CornerNormals.h"
#include "geometry/SurfaceQuery.h"

namespace dipwright {

// How much of the sky is open, 0 … 1, over each position of a mesh (ambient occlusion), and over
// the table under it. Computed once, by rays on all cores; read from any thread.
class SkyLight {
public:
    SkyLight(const TriangleMesh& mesh, const SurfaceQuery& query);

    float onBody(const SurfacePoint& point) const;
    // On the table, y = tableHeight(), at x and z.
    float onTable(float x, float z) const;
    float tableHeight() const { return tableHeight_; }

private:
    static constexpr int tableCells = 96;

    const TriangleMesh& mesh_;
    std::vector<float> body_; // a position each
    float tableHeight_ = 0;
    Eigen::Vector2f tableOrigin_ = Eigen::Vector2f::Zero();
    float tableSpacing_ = 1;
    std::vector<float> table_; // (tableCells + 1)², rows along x
};

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
