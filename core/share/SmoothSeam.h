// Turns a cut along triangle edges into a smooth line.
#pragma once

#include "geometry/SurfaceDistance.h"
#include "geometry/TriangleMesh.h"

namespace dipwright {

// Smooths the border between triangles with label 0 and 1 by heat diffusion over `width` mm.
// Returns a value per position: positive on the side of label 0, zero on the line. Patches narrower
// than `width` disappear.
std::vector<float> smoothBorder(const TriangleMesh& mesh, const std::vector<std::uint8_t>& labels,
                                double width);

// Returns the distance of each position from the zero line of `field` along the surface, with the
// sign of `field`. Distances are limited to `limit`. If there is no zero line, all distances are
// `limit`. `measured` is as in surfaceDistance().
std::vector<float> signedDistance(const TriangleMesh& mesh, const std::vector<float>& field,
                                  float limit, const UnfoldedTriangles& measured = {});

// Returns the length of the gradient of a function that is linear in a triangle and has these
// corner values, per mm.
float steepness(const std::array<Eigen::Vector3f, 3>& corners, const std::array<float, 3>& values);
// Returns the length of the gradient in one triangle of a mesh; `field` is per position.
float steepness(const TriangleMesh& mesh, std::size_t triangle, const std::vector<float>& field);

} // namespace dipwright
