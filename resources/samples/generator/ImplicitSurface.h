// Makes triangle meshes of surfaces that are the zero set of a function.
#pragma once

#include "geometry/TriangleMesh.h"

#include <functional>

namespace dipwright::samples {

// A function whose value is approximately the signed distance: negative inside, zero on the
// surface, with a continuous gradient.
using Field = std::function<float(const Eigen::Vector3f&)>;

// Returns the gradient by central differences.
Eigen::Vector3f slope(const Field& field, const Eigen::Vector3f& place);

// Returns the closed surface inside `box`; the surface must not touch the box. Uses surface nets:
// one vertex for each grid cell that the surface crosses and one quadrilateral for each crossed
// grid edge. Then moves the vertices onto the surface and spaces them evenly along it. Edges are
// about `step` long.
TriangleMesh surfaceMesh(const Field& field, const BoundingBox& box, float step);

// Cuts triangles at the plane y = 0, so that each triangle lies on one side of it. First moves
// vertices that are closer to the plane than `snap` onto the plane. A closed mesh stays closed.
TriangleMesh cutAtGround(TriangleMesh mesh, float snap);

} // namespace dipwright::samples
