// The amounts of ink of a body's textures in CMYK, as appearances that are reversed like colours.
#pragma once

#include "model/TexturedMesh.h"

namespace dipwright {

// Returns the space of the inks (base/InkPicture.h) that a body shows: that of its first texture
// with amounts of ink. Empty if it has none. Textures in another space count as colours.
QString inkSpaceOf(const SurfaceAppearance& appearance);

// Which amounts an appearance shows as 1 − linear light in red, green and blue.
enum class InkPlane {
    Colours, // cyan, magenta, yellow
    Black    // black; then 1 where the body has amounts of ink, 0 where it has only colours
};
// Returns the appearance of one plane, with wide textures. Plain materials have no ink.
SurfaceAppearance inkAppearance(const SurfaceAppearance& appearance, InkPlane plane);

} // namespace dipwright
