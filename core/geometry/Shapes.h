// Meshes of simple shapes for the benchmark, the physics validation and the tests. All are closed,
// centred on the origin unless stated otherwise, in mm, Y up.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Divided into rings of latitude and segments of longitude. The poles are single points on the Y
// axis. Has 2 + (rings − 1)·segments positions.
TriangleMesh sphereMesh(double radius, int rings, int segments);
TriangleMesh ellipsoidMesh(const Eigen::Vector3d& radii, int rings, int segments);
// The apex points down at y = 0, the flat top lies at y = height, the axis is Y. The half-angle is
// between axis and side.
TriangleMesh coneMesh(double halfAngleRadians, double height, int segments);
TriangleMesh boxMesh(const Eigen::Vector3d& size);
// A horizontal cylinder along Z with flat ends.
TriangleMesh cylinderMesh(double radius, double length, int segments);
// A torus about the Y axis: a tube around the circle with radius `circleRadius` in the plane y = 0.
TriangleMesh torusMesh(double circleRadius, double tubeRadius, int rings, int segments);
// A regular tetrahedron with edges of length `edge`, one face down, its centroid at the origin.
TriangleMesh tetrahedronMesh(double edge);

} // namespace dipwright
