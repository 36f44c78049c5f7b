// Finds short ways along a surface.
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"

namespace dipwright {

// Returns the points of a line on the surface from one place to another, in this order, mm. Between
// two points the line is straight and lies in one triangle. The line cannot be shortened by moving
// its points along the edges that it crosses; on a strongly curved surface, a way along other
// triangles may be slightly shorter. Returns no points if the places are not connected.
// Throws Cancelled.
std::vector<Eigen::Vector3f> surfacePath(const TriangleMesh& mesh, const SurfacePoint& from,
                                         const SurfacePoint& to, const CancelToken& cancel = {});

// Returns the length of a line through these points, mm.
double lengthOf(const std::vector<Eigen::Vector3f>& line);

} // namespace dipwright
