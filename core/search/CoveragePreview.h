// Predicts the painted area of a dip from the body's shape alone. Used while the user turns a pose,
// and in the first stage of the pose search (docs/pose-search.md, "By the body's shape").
#pragma once

#include "geometry/RefinedMesh.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <memory>

namespace dipwright {

class AirInPoses;
namespace solver {
struct BodyPath;
}

struct PreviewedCoverage {
    double share = 0;                  // covered share of the surface, 0 … 1
    std::vector<std::uint8_t> covered; // per triangle of CoveragePreview::mesh(): 1 if painted
};

// Made once for a model and used for many poses. It may be wrong for faces near the overhang
// (docs/pose-search.md, "The preview"). Immutable; any thread may use it. Deterministic.
class CoveragePreview {
public:
    // Number of cells of its height field along the longer side of the body's shadow.
    static constexpr int heightCells = 160;

    explicit CoveragePreview(const TriangleMesh& model);

    // Predicts the coverage of a dip. Film covers faces that point down with nothing below them.
    // From there it spreads over walls that turn up by at most the overhang. It ends at the depth
    // of the dip, at the film's edge and at trapped air. On a path, each face counts as it is at
    // the moment at which it goes under water. A path that cannot be travelled covers nothing.
    PreviewedCoverage at(const Immersion& immersion, const FilmSettings& film,
                         const ProcessSettings& process) const;
    // Converts a coverage to triangles of the model: 1 if at least half of the triangle is painted.
    std::vector<std::uint8_t> ofModel(const PreviewedCoverage& coverage) const;

    const TriangleMesh& model() const { return model_; }
    // The model with its large triangles divided.
    const TriangleMesh& mesh() const { return fine_.mesh(); }
    // Per triangle of mesh(), mm²; 0 if it is buried (BuriedSurface.h).
    const std::vector<float>& areas() const { return areas_; }
    const std::vector<Eigen::Vector3f>& normals() const { return normals_; }
    // Centres of the triangles of mesh(), mm in the model's coordinates.
    const std::vector<Eigen::Vector3f>& middles() const { return middles_; }

private:
    // `path`: of the model; `pose`: poseTransform() of the immersion.
    PreviewedCoverage on(const solver::BodyPath& path, const Eigen::Isometry3d& pose,
                         const Immersion& immersion, const FilmSettings& film,
                         const ProcessSettings& process) const;

    TriangleMesh model_;
    RefinedMesh fine_;
    std::vector<float> areas_;
    std::vector<Eigen::Vector3f> normals_, middles_; // per triangle of the fine mesh
    std::vector<std::uint32_t> opposite_;            // oppositeEdges() of the fine mesh
    std::shared_ptr<const AirInPoses> air_;          // of the fine mesh
    double area_ = 0;
    bool isClosed_ = false; // the fine mesh has no border
};

} // namespace dipwright
