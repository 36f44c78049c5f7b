// Hollow bodies of revolution, whose trapped air is known in closed form.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright::test {

// Turns a profile of (radius, height) round the Y axis. Its points go from first to last as seen
// from outside, with the axis to the left.
TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile, int segments);

// Half a hollow ball, its rim in the plane y = 0, its dome up. It has a round hole at the top if
// `holeRadius` > 0. Lengths in mm.
inline constexpr double bowlRadius = 32, bowlWall = 3;
TriangleMesh bowl(double holeRadius = 0);

// A cup of outer radius 30 mm, wall 3 mm and height 40 mm. Its inside is 37 mm deep.
TriangleMesh cup();

} // namespace dipwright::test
