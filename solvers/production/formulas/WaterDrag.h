// The drag of the water on the floating film.
//
// While the body touches the film in only one small place, nothing elastic keeps the film from
// rotating about that place. A small residual torque of the few triangles on the contact line would
// rotate the whole film by degrees. The water prevents this rotation: it resists in proportion to
// the film's speed over the water. The drag moves no strained film by more than 0.01 mm.
#pragma once

#include "common/HostDevice.h"

namespace dipwright::numerics {

// Drag force on the film per mm² of film and per mm of its motion in 1 mm of descent, relative to
// the film's shear stiffness.
inline constexpr double waterDrag = 5e-6;

// Returns the drag force on one point with the area of a cell, per mm of its motion in a step with
// the descent `increment`.
DIPWRIGHT_HOST_DEVICE inline double pointDrag(double spacingX, double spacingZ, double increment) {
    return waterDrag * spacingX * spacingZ / increment;
}

} // namespace dipwright::numerics
