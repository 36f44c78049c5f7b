// Computes the sample bodies: shape, charts and painted texture. Millimetres, Y up.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright::samples {

// Returns a sphere of 70 mm diameter. Longitude and latitude are its texture coordinates, with the
// seam 45° beside the front (+Z). Its picture has a graticule of 15° and letters, so that errors in
// place are visible.
TexturedMesh sphere();

// Returns a tetrahedron with edges of 60 mm, one face down. Each face is a chart with a letter and
// a 5 mm grid.
TexturedMesh tetrahedron();

// Returns a sea turtle, 110 mm from nose (+Z) to tail and 75 mm across the flippers. Its two
// charts, top and bottom, meet along its outline.
TexturedMesh turtle();

} // namespace dipwright::samples
