// Bodies with closed forms, for the benchmark, the physics validation and the tests. All closed,
// centred on the origin unless said otherwise, mm, Y up.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Rings of latitude × segments of longitude; the poles are single points on the Y axis.
// 2 + (rings − 1)·segments positions.
TriangleMesh sphereMesh(double radius, int rings, int segments);
TriangleMesh ellipsoidMesh(const Eigen::Vector3d& radii, int rings, int segments);
// Apex down at y = 0, axis Y, flat top at y = height; half-angle between axis and side.
TriangleMesh coneMesh(double halfAngleRadians, double height, int segments);
TriangleMesh boxMesh(const Eigen::Vector3d& size);
// A lying cylinder along Z with flat ends.
TriangleMesh cylinderMesh(double radius, double length, int segments);
// A torus about the Y axis: a tube round the circle y = 0 of `circleRadius`.
TriangleMesh torusMesh(double circleRadius, double tubeRadius, int rings, int segments);
// A regular tetrahedron, one face down, by its edge; its centroid is the origin.
TriangleMesh tetrahedronMesh(double edge);

} // namespace dipwright
