// Weighs the places of a body for a pose search. Private to this folder.
#pragma once

#include "geometry/TriangleMesh.h"
#include "search/SearchSubject.h"
#include "settings/ToleranceSettings.h"
#include "texture/LinearLight.h"

namespace dipwright {

// Returns the weight of each place: the weight of its zone, or 0 where the model needs no ink or is
// masked. If no weighted place needs ink, the zones alone count. `colours` holds the colour of each
// place (texture/SurfaceColours.h).
std::vector<float> placeWeights(const SearchSubject& subject,
                                const std::array<double, zoneCount>& zoneWeights,
                                const std::vector<SurfacePoint>& places,
                                const std::vector<LinearColour>& colours);

} // namespace dipwright
