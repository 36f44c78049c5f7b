// Defines the turtle's shape as the zero set of a function.
//
// Each part of the turtle is an ellipsoid about a centre in the plane y = 0, higher above the plane
// than below. So the outline lies in that plane. The surface above and below it has no overhangs,
// so film can reach it. Finally the turtle is bent (lift()).
#pragma once

#include <Eigen/Core>

namespace dipwright::samples {

struct Part {
    Eigen::Vector2f centre; // x, z
    float turned;           // rotation in radians, from the Z axis towards the X axis
    float along;            // radii of the ellipsoid, mm
    float across;
    float above;
    float below;
};

// Returns 0 up to `from`, 1 from `to` on, and a smooth transition between.
float smoothStep(float from, float to, float value);

extern const Part turtleShell;

// Returns approximately the distance to the shell, mm; negative inside.
float shellDistance(const Eigen::Vector3f& place);
// Returns approximately the distance to all other parts, mm; negative inside.
float limbDistance(const Eigen::Vector3f& place);
// Returns the distance to the whole turtle, with a smooth transition between shell and other parts.
float turtleField(const Eigen::Vector3f& place);

// Returns how far bending raises a place, mm. The head looks up, and the flippers hang down.
float lift(const Eigen::Vector3f& place);

// Returns the place mirrored to the side x ≥ 0, because the turtle is symmetric.
Eigen::Vector3f mirrored(const Eigen::Vector3f& place);

} // namespace dipwright::samples
