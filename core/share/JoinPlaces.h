// Where a join between two dips would be seen least.
#pragma once

#include "geometry/RefinedMesh.h"
#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"
#include "share/BodyShare.h"
#include "share/MinimumCut.h"
#include "texture/LinearLight.h"

namespace dipwright {

struct JoinPlaces {
    std::vector<LinearColour> colours; // a fine triangle each: the mean of what it is to show
    // A fine triangle each: how much a mm of join would be seen there, contrast × visibility.
    std::vector<float> weights;
};

// `model` is the coarse mesh's, `query` of it. All cores.
JoinPlaces joinPlaces(const RefinedMesh& body, const TexturedMesh& model,
                      const SurfaceQuery& query);

// The edges between fine triangles with what a join along each would cost, mm: its length times the
// weight there, less along a crease.
std::vector<CutEdge> joinEdges(const RefinedMesh& body, const std::vector<float>& weights);

// The line where `field`, a number a position, is 0, in pieces from the triangles that it crosses.
struct LinePiece {
    std::uint32_t triangle = 0;
    std::array<Eigen::Vector3f, 2> ends;
};
std::vector<LinePiece> zeroLine(const TriangleMesh& mesh, const std::vector<float>& field);

JoinCost joinCost(const std::vector<LinePiece>& line, const std::vector<float>& weights);

} // namespace dipwright
