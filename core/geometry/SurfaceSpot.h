// Parts of a mesh around a place on it.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Returns the distance of each position from a place along the surface, mm; infinity beyond
// `limit`.
std::vector<float> distanceFrom(const TriangleMesh& mesh, const SurfacePoint& place, float limit);
// Returns the triangles whose corners are on average at most `radius` mm away along the surface,
// and the place's own triangle.
std::vector<std::uint32_t> trianglesWithin(const TriangleMesh& mesh, const SurfacePoint& middle,
                                           float radius);
// Returns the face that a triangle lies on: connected triangles whose normals differ by at most
// 15°.
std::vector<std::uint32_t> faceRound(const TriangleMesh& mesh, std::uint32_t triangle);

} // namespace dipwright
