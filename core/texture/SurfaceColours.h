// What a body is to look like, place by place.
#pragma once

#include "model/TexturedMesh.h"
#include "texture/LinearLight.h"

namespace dipwright {

// The colour of the texture, or the plain one, at each of these places of the body, in linear
// light; of a fine pattern a single texel. All cores.
std::vector<LinearColour> surfaceColours(const TexturedMesh& model,
                                         const std::vector<SurfacePoint>& places);

} // namespace dipwright
