// Defines the turtle's shape as the zero set of a function.
//
// The turtle is defined level: each part is an ellipsoid about a centre in the plane y = 0, higher
// above the plane than below. So the outline lies in that plane. Above and below it the surface has
// no overhangs, so film can reach it. Finally the turtle is bent (lift).
#pragma once

#include <Eigen/Core>

namespace dipwright::samples {

struct Part {
    Eigen::Vector2f centre; // x, z
    float turned;           // radians, from the Z axis towards the X axis
    float along;            // radii
    float across;
    float above;
    float below;
};

// Returns 0 up to `from`, 1 from `to` on, and a smooth transition between.
float smoothStep(float from, float to, float value);

extern const Part turtleShell;

// Return approximately the distances to the shell and to all other parts, mm; negative inside.
float shellDistance(const Eigen::Vector3f& place);
float limbDistance(const Eigen::Vector3f& place);
// Returns the distance to both, with a smooth transition between them.
float turtleField(const Eigen::Vector3f& place);

// Returns how far a place is raised by the bending, mm: the head looks up, the flippers hang down.
float lift(const Eigen::Vector3f& place);

// Returns the mirrored place on the side x ≥ 0. The turtle is symmetric.
Eigen::Vector3f mirrored(const Eigen::Vector3f& place);

} // namespace dipwright::samples
