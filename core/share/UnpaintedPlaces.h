// Lists the pieces of the body that neither dip paints.
#pragma once

#include "share/BodyShare.h"

namespace dipwright {

class SurfaceMask;

// Returns the pieces of at least 1 mm², without masked surface, largest first. `mask` belongs to
// the same body and may be null.
std::vector<UnpaintedPlace> unpaintedPlaces(const BodyShare& share, const SurfaceMask* mask);

} // namespace dipwright
