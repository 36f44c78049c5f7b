// Rates how visible a seam between two dips would be at each place of the body.
#pragma once

#include "geometry/RefinedMesh.h"
#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"
#include "share/BodyShare.h"
#include "share/MinimumCut.h"
#include "texture/LinearLight.h"

namespace dipwright {

struct SeamPlaces {
    std::vector<LinearColour> colours; // per fine triangle: mean colour that it is to show
    // Per fine triangle: how visible 1 mm of seam is there (contrast × visibility of the place).
    std::vector<float> weights;
};

// Rates the fine triangles of `body`. `model` has the coarse mesh of `body`; `query` must search
// that mesh. Uses all cores.
SeamPlaces seamPlaces(const RefinedMesh& body, const TexturedMesh& model,
                      const SurfaceQuery& query);

// Returns the edges between fine triangles with the cost of a seam along each, mm. The cost is the
// edge's length times the weight there; it is lower along a crease.
std::vector<CutEdge> seamCutEdges(const RefinedMesh& body, const std::vector<float>& weights);

// A piece of a line on the body, within one triangle.
struct LinePiece {
    std::uint32_t triangle = 0;
    std::array<Eigen::Vector3f, 2> ends;
};
// Returns the line where `field` is 0, one piece per triangle that the line crosses. `field` is per
// position.
std::vector<LinePiece> zeroLine(const TriangleMesh& mesh, const std::vector<float>& field);

SeamCost seamCost(const std::vector<LinePiece>& line, const std::vector<float>& weights);

} // namespace dipwright
