// Hollow bodies of revolution, whose trapped air is known in closed form.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright::test {

// Returns the body of revolution of a profile of (radius, height) about the Y axis. The profile's
// points are in the order in which they are seen from outside, with the axis to the left.
TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile, int segments);

// Returns half a hollow ball with its rim in the plane y = 0 and its dome up. If `holeRadius` > 0,
// it has a round hole at the top. Lengths in mm.
inline constexpr double bowlRadius = 32, bowlWall = 3;
TriangleMesh bowl(double holeRadius = 0);

// Returns a cup of outer radius 30 mm, wall 3 mm and height 40 mm. Its inside is 37 mm deep.
TriangleMesh cup();

} // namespace dipwright::test
