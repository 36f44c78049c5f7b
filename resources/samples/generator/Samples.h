// Makes the sample bodies: shape, charts and painted texture. Millimetres, Y up.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright::samples {

// Returns a sphere of 70 mm diameter. Its texture coordinates are longitude and latitude, with the
// seam 45° to the right of the front (+Z). Its texture has a grid of meridians and parallels every
// 15°, and letters, so that errors in place are visible.
TexturedMesh sphere();

// Returns a tetrahedron with edges of 60 mm, standing on one face. Each face is a chart with a
// letter and a 5 mm grid.
TexturedMesh tetrahedron();

// Returns a sea turtle, 110 mm from nose (+Z) to tail and 75 mm across the flippers. Its two
// charts, top and bottom, meet along its outline.
TexturedMesh turtle();

} // namespace dipwright::samples
