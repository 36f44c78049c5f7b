// Parts of a mesh round a place on it.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// How far each position is from a place, along the surface, mm; infinity past `limit`.
std::vector<float> distanceFrom(const TriangleMesh& mesh, const SurfacePoint& place, float limit);
// The triangles whose corners are on the mean no farther away than `radius` mm along the surface,
// and the place's own.
std::vector<std::uint32_t> trianglesWithin(const TriangleMesh& mesh, const SurfacePoint& middle,
                                           float radius);
// The face that a triangle lies on: what hangs together with it and looks the same way, to 15
// degrees.
std::vector<std::uint32_t> faceRound(const TriangleMesh& mesh, std::uint32_t triangle);

} // namespace dipwright
