// The triangles of a form on a grid.
#pragma once

#include "geometry/DistanceField.h"

namespace dipwright {

// The surface at 0, closed where the grid's outermost samples are positive; outwards is where
// values rise. By flying edges (Schroeder, Maynard & Geveci, LDAV 2015): two triangles, about, for
// each cell that it passes.
TriangleMesh formSurface(const DistanceField& form);

} // namespace dipwright
