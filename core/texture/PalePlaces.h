// Tells where a body will be visibly too pale.
#pragma once

#include "dip/LaidFilm.h"
#include "texture/Ink.h"

namespace dipwright {

// Returns for each of `places` on the body whether the film stretches more there than ink can make
// up for; 0 where the film does not paint. `wanted` has one colour for each place, as the body
// should show it (InkCompensation::toned()). Uses all cores.
std::vector<std::uint8_t> palePlaces(const LaidFilm& laid, const std::vector<SurfacePoint>& places,
                                     const std::vector<LinearColour>& wanted,
                                     const InkCompensation& ink);

} // namespace dipwright
