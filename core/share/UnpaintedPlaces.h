// Lists the pieces of the body that neither dip paints.
#pragma once

#include "share/BodyShare.h"

namespace dipwright {

class SurfaceMask;

// Returns the pieces of at least 1 mm², without masked and buried surface, largest first. `body` is
// the shared body in any pose. `mask` belongs to it and may be null.
std::vector<UnpaintedPlace> unpaintedPlaces(const BodyShare& share, const PosedBody& body,
                                            const SurfaceMask* mask);

} // namespace dipwright
