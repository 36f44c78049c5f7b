// Hollow bodies of revolution, whose trapped air is known in closed form.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright::test {

// A profile of (radius, height) turned round the Y axis, first point to last seen from outside with
// the axis to the left.
TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile, int segments);

// Half a hollow ball, its rim in the plane y = 0, its dome up; with a round hole at the top where
// that has a radius.
inline constexpr double bowlRadius = 32, bowlWall = 3;
TriangleMesh bowl(double holeRadius = 0);

// A cup of outer radius 30, wall 3 and height 40; its inside is a pit 37 deep.
TriangleMesh cup();

} // namespace dipwright::test
