// What is to be said of a model's textures.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>

namespace dipwright {

// A sentence for each texture whose colours were not all read as they were meant
// (base/ColourNote.h).
QStringList colourNotes(const SurfaceAppearance& appearance);

} // namespace dipwright
