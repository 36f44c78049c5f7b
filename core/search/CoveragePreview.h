// What a dip would paint, by the body's shape alone: for the eye while a pose is being turned, and
// for the first stage of the pose search (docs/pose-search.md, "By its shape").
#pragma once

#include "geometry/RefinedMesh.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <memory>

namespace dipwright {

class AirInPoses;

struct PreviewedCoverage {
    double share = 0;                  // of the surface, 0 … 1
    std::vector<std::uint8_t> covered; // a triangle of CoveragePreview::mesh() each: 1 is painted
};

// Made once for a model, asked for each pose. Faces near the overhang may be told wrong
// (docs/pose-search.md, "The preview"). Immutable; any thread may ask. Deterministic.
class CoveragePreview {
public:
    explicit CoveragePreview(const TriangleMesh& model);

    // Film lies on what faces down without anything below it, and goes on from there over walls
    // that turn up by no more than the overhang, as far as the dip goes under and the sheet
    // reaches; none where air is trapped.
    PreviewedCoverage at(const Immersion& immersion, const FilmSettings& film,
                         const ProcessSettings& process) const;
    // The same, a triangle of the model each: 1 where at least half of it is painted.
    std::vector<std::uint8_t> ofModel(const PreviewedCoverage& coverage) const;

    const TriangleMesh& model() const { return model_; }
    // The model, its large triangles cut.
    const TriangleMesh& mesh() const { return fine_.mesh(); }
    SurfacePoint middle(std::size_t fine) const { return fine_.middle(fine); } // of the model
    const std::vector<float>& areas() const { return areas_; } // mm², a triangle of mesh() each
    const std::vector<Eigen::Vector3f>& normals() const { return normals_; }

private:
    TriangleMesh model_;
    RefinedMesh fine_;
    std::vector<float> areas_;
    std::vector<Eigen::Vector3f> normals_;
    std::vector<std::uint32_t> opposite_;   // oppositeEdges() of the fine mesh
    std::shared_ptr<const AirInPoses> air_; // of the fine mesh
    double area_ = 0;
};

} // namespace dipwright
