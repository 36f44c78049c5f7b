// Triangle meshes of surfaces that are given as the zero of a function.
#pragma once

#include "geometry/TriangleMesh.h"

#include <functional>

namespace dipwright::samples {

// Roughly a distance: negative inside, zero on the surface, continuous with its slope.
using Field = std::function<float(const Eigen::Vector3f&)>;

// The gradient, by central differences.
Eigen::Vector3f slope(const Field& field, const Eigen::Vector3f& place);

// The closed surface inside `box` (which it must not touch) by surface nets: a vertex for each grid
// cell that the surface crosses, a quadrilateral for each grid edge, then drawn onto the surface
// and evened out along it. Edges come out about `step` long.
TriangleMesh surfaceMesh(const Field& field, const BoundingBox& box, float step);

// Cuts triangles at the plane y = 0, so that each lies on one side of it. Vertices that are nearer
// to it than `snap` are moved onto it first. A closed mesh stays closed.
TriangleMesh cutAtGround(TriangleMesh mesh, float snap);

} // namespace dipwright::samples
