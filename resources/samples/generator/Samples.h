// The sample bodies: shape, charts and painted texture, all computed. Millimetres, Y up.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright::samples {

// 70 mm across. Longitude and latitude as texture coordinates, the seam 45° beside the front (+Z);
// a graticule of 15° and letters, so that one sees where everything lands.
TexturedMesh sphere();

// Edges of 60 mm, one face down; each face a chart of its own with a letter and a 5 mm grid.
TexturedMesh tetrahedron();

// A sea turtle, 110 mm from nose (+Z) to tail and 75 mm across the flippers. Two charts, above and
// below, that meet along its outline.
TexturedMesh turtle();

} // namespace dipwright::samples
