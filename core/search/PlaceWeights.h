// How much the places of a body matter to a search. Private to this folder.
#pragma once

#include "geometry/TriangleMesh.h"
#include "search/SearchSubject.h"
#include "settings/ToleranceSettings.h"
#include "texture/LinearLight.h"

namespace dipwright {

// Of each of these places of the subject's model: the weight of its zone, or 0 where the model is
// to stay without ink, unless it is to stay so wherever a zone weighs anything. `colours`: what
// each place is to show (texture/SurfaceColours.h).
std::vector<float> placeWeights(const SearchSubject& subject,
                                const std::array<double, zoneCount>& zoneWeights,
                                const std::vector<SurfacePoint>& places,
                                const std::vector<LinearColour>& colours);

} // namespace dipwright
