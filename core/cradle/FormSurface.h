// Extracts the triangle surface of a form on a grid.
#pragma once

#include "geometry/DistanceField.h"

namespace dipwright {

// Returns the surface at value 0, facing towards rising values. It is closed if the outermost
// samples of the grid are positive. Uses flying edges (Schroeder, Maynard & Geveci, LDAV 2015),
// which make about two triangles per crossed cell.
TriangleMesh formSurface(const DistanceField& form);

} // namespace dipwright
