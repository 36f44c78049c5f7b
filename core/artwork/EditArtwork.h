// Layers of artwork that are begun, placed on a model and added, and what they come out as.
#pragma once

#include "model/TexturedMesh.h"
#include "settings/Artwork.h"

#include <QStringList>
#include <array>

namespace dipwright {

// A layer as it is best begun with: patterns as a box in their usual scale and colours, others as a
// decal. `name`: what it is called.
ArtworkLayer newLayer(LayerKind kind, const QString& name);

// The layer on a model it has not been placed on yet: decals in the middle of its front, the side
// that looks along +Z, others about its middle; no larger than looks well there.
ArtworkLayer placedOn(const TexturedMesh& model, ArtworkLayer layer);

// Lays it over all others. The first on a model without a texture makes white, which is no ink, the
// base, so that not all of the body is printed in the model's plain colour. Throws Error past
// mostArtworkLayers.
void addLayer(Artwork& artwork, const ArtworkLayer& layer, const TexturedMesh& model);

// How large what a layer shows comes out, in the area that it takes: a picture or text shown once
// keeps its proportions. Text needs a QGuiApplication.
std::array<Millimetres, 2> shownSize(const ArtworkLayer& layer);

// A sentence for each layer whose font this computer has not: it is drawn in another. Needs a
// QGuiApplication.
QStringList fontWarnings(const Artwork& artwork);
// What is to be said of how the colours of its pictures were read, a sentence for each of which
// something is (base/ColourNote.h).
QStringList colourNotes(const Artwork& artwork);

} // namespace dipwright
