// Makes triangle meshes of surfaces that are the zero set of a function.
#pragma once

#include "geometry/TriangleMesh.h"

#include <functional>

namespace dipwright::samples {

// Approximately the signed distance: negative inside, zero on the surface, with a continuous
// gradient.
using Field = std::function<float(const Eigen::Vector3f&)>;

// Returns the gradient by central differences.
Eigen::Vector3f slope(const Field& field, const Eigen::Vector3f& place);

// Returns the closed surface inside `box`, which it must not touch. Uses surface nets: a vertex for
// each grid cell that the surface crosses and a quadrilateral for each grid edge. The vertices are
// then moved onto the surface and evened out along it. Edges are about `step` long.
TriangleMesh surfaceMesh(const Field& field, const BoundingBox& box, float step);

// Cuts triangles at the plane y = 0, so that each lies on one side of it. Vertices closer to the
// plane than `snap` are moved onto it first. A closed mesh stays closed.
TriangleMesh cutAtGround(TriangleMesh mesh, float snap);

} // namespace dipwright::samples
