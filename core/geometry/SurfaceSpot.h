// Finds the parts of a mesh around a place on it.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Returns the distance along the surface from a place to each position, mm; infinity beyond
// `limit`.
std::vector<float> distanceFrom(const TriangleMesh& mesh, const SurfacePoint& place, float limit);
// Returns the triangles whose corners are on average at most `radius` mm away along the surface.
// The place's own triangle is always among them.
std::vector<std::uint32_t> trianglesWithin(const TriangleMesh& mesh, const SurfacePoint& middle,
                                           float radius);
// Returns the face that a triangle lies on: the connected triangles whose normals differ from its
// normal by at most 15°.
std::vector<std::uint32_t> faceAround(const TriangleMesh& mesh, std::uint32_t triangle);
// The same with oppositeEdges() of the mesh, for several faces.
std::vector<std::uint32_t> faceAround(const TriangleMesh& mesh,
                                      const std::vector<std::uint32_t>& opposite,
                                      std::uint32_t triangle);

} // namespace dipwright
