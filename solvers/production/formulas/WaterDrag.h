// The drag of the water on the floating film.
//
// While the body has touched in one small place only, nothing elastic keeps the film from turning
// about it: what the few triangles on the contact line leave of a torque would spin the whole sheet
// by degrees. The water does keep it: it resists in proportion to the film's speed over it. The
// drag taken here moves no film that is strained by more than a hundredth of a millimetre.
#pragma once

#include "common/HostDevice.h"

namespace dipwright::numerics {

// Force on the film per mm² of it and per mm that it moves in one mm of descent, over the film's
// shear stiffness.
inline constexpr double waterDrag = 5e-6;

// Force on one point, which stands for a cell's area, per mm that it moves in a step in which the
// body comes down by `increment`.
DIPWRIGHT_HOST_DEVICE inline double pointDrag(double spacingX, double spacingZ, double increment) {
    return waterDrag * spacingX * spacingZ / increment;
}

} // namespace dipwright::numerics
