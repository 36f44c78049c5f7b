// The turtle's shape, as the zero of a function.
//
// It is drawn level: each part is an ellipsoid about a centre in the plane y = 0, higher above it
// than below. So the outline lies in that plane, and above and below it the surface is a landscape
// without overhangs, which film can reach. At the end it is bent (lift).
#pragma once

#include <Eigen/Core>

namespace dipwright::samples {

struct Part {
    Eigen::Vector2f centre; // x, z
    float turned;           // radians from the Z axis towards the X axis
    float along;            // radii
    float across;
    float above;
    float below;
};

// 0 up to `from`, 1 from `to` on, smooth between.
float smoothStep(float from, float to, float value);

extern const Part turtleShell;

// Nearly the distances, mm, from the shell and from all else; negative inside.
float shellDistance(const Eigen::Vector3f& place);
float limbDistance(const Eigen::Vector3f& place);
// Both together, with a smooth passage between them.
float turtleField(const Eigen::Vector3f& place);

// How far a place is raised at the end: the head looks up, the flippers hang down.
float lift(const Eigen::Vector3f& place);

// The turtle is the same on both sides: the place as it would be on the side x ≥ 0.
Eigen::Vector3f mirrored(const Eigen::Vector3f& place);

} // namespace dipwright::samples
