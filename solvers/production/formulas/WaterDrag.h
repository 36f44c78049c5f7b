// The drag of the water on the floating film.
//
// While the body touches the film in only one small place, nothing elastic keeps the film from
// rotating about it. A small residual torque of the few triangles on the contact line would rotate
// the whole film by degrees. The water prevents this: it resists in proportion to the film's speed
// over it. This drag moves no strained film by more than a hundredth of a millimetre.
#pragma once

#include "common/HostDevice.h"

namespace dipwright::numerics {

// Force on the film per mm² and per mm of motion in 1 mm of descent, relative to the film's shear
// stiffness.
inline constexpr double waterDrag = 5e-6;

// Returns the force on one point with a cell's area, per mm of motion in a step with the descent
// `increment`.
DIPWRIGHT_HOST_DEVICE inline double pointDrag(double spacingX, double spacingZ, double increment) {
    return waterDrag * spacingX * spacingZ / increment;
}

} // namespace dipwright::numerics
