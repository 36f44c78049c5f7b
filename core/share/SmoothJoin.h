// From a cut along the edges of triangles to a smooth line.
#pragma once

#include "geometry/SurfaceDistance.h"
#include "geometry/TriangleMesh.h"

namespace dipwright {

// The border between triangles with label 0 and 1, smoothed as heat would blur it over `width` mm:
// a number a position, above 0 on the side of label 0 and 0 on the line. A patch of either label
// that is narrower than that goes.
std::vector<float> smoothBorder(const TriangleMesh& mesh, const std::vector<std::uint8_t>& labels,
                                double width);

// How far each position is from where `field` is 0, along the surface, with the field's sign; past
// `limit` the limit. The limit everywhere where it is nowhere 0. `measured` as surfaceDistance has
// it.
std::vector<float> signedDistance(const TriangleMesh& mesh, const std::vector<float>& field,
                                  float limit, const UnfoldedTriangles& measured = {});

// The gradient's length, a mm, of what is linear in a triangle and has these values at its corners.
float steepness(const std::array<Eigen::Vector3f, 3>& corners, const std::array<float, 3>& values);
// Of a field, a number a position.
float steepness(const TriangleMesh& mesh, std::size_t triangle, const std::vector<float>& field);

} // namespace dipwright
