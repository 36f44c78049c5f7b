// Judges marked zones of the body, and its separate bodies, by the share that no dip paints.
#pragma once

#include "accuracy/verdict/Verdict.h"

#include <cstdint>
#include <span>

namespace dipwright {

// Adds a reason for each of zones A and B that is painted on too little of its surface. `zones` and
// `painted` describe the same evenly spread places: their zones, and a value that is 0 where no dip
// paints. `limit`: VerdictSettings::zoneBare.
void addBareZoneReasons(ReasonList& found, std::span<const Zone> zones,
                        std::span<const std::uint8_t> painted, double limit);

// Adds a reason for each separate body that is painted on too little of its surface. `places` are
// evenly spread, without masked places; `painted` as above. `least`: VerdictSettings::leastPainted.
void addBareBodyReasons(ReasonList& found, const SeparateBodies& bodies,
                        std::span<const SurfacePoint> places, std::span<const std::uint8_t> painted,
                        double least);

} // namespace dipwright
