// Meshes of simple shapes for the benchmark, the physics validation and the tests. All meshes are
// closed, in mm and with Y up. They are centred on the origin unless stated otherwise.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// A sphere, divided into rings of latitude and segments of longitude. The poles are single points
// on the Y axis. The mesh has 2 + (rings − 1)·segments positions.
TriangleMesh sphereMesh(double radius, int rings, int segments);
TriangleMesh ellipsoidMesh(const Eigen::Vector3d& radii, int rings, int segments);
// A cone about the Y axis. Its apex is at y = 0 and points down; its flat top is at y = height. The
// half-angle is the angle between the axis and the side.
TriangleMesh coneMesh(double halfAngleRadians, double height, int segments);
TriangleMesh boxMesh(const Eigen::Vector3d& size);
// A horizontal cylinder along Z with flat ends.
TriangleMesh cylinderMesh(double radius, double length, int segments);
// A torus about the Y axis: a tube around the circle with radius `circleRadius` in the plane y = 0.
TriangleMesh torusMesh(double circleRadius, double tubeRadius, int rings, int segments);
// A regular tetrahedron with edges of length `edge`, one face down, its centroid at the origin.
TriangleMesh tetrahedronMesh(double edge);

} // namespace dipwright
