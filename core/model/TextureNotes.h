// Notes for the user about a model's textures.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>

namespace dipwright {

// Returns a sentence for each texture whose colours could not all be read as intended
// (base/ColourNote.h).
QStringList colourNotes(const SurfaceAppearance& appearance);

} // namespace dipwright
