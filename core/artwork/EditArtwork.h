// Creates layers of artwork, places them on a model, and reports problems with their fonts and
// colours.
#pragma once

#include "model/TexturedMesh.h"
#include "settings/Artwork.h"

#include <QStringList>
#include <array>

namespace dipwright {

// Returns a new layer with good defaults. A pattern is placed as a box, with its usual scale and
// colours. Any other layer is placed as a decal.
ArtworkLayer newLayer(LayerKind kind, const QString& name);

// Returns the layer placed on a model for the first time. A decal goes to the middle of the front,
// the side that faces +Z. Any other layer is placed round the middle of the model. The layer's size
// is limited to suit the model.
ArtworkLayer placedOn(const TexturedMesh& model, ArtworkLayer layer);

// Returns the layer with another placement. A layer that wraps around an axis, or comes from six
// sides, moves into the middle of the model, because a place on the surface hardly suits its axis.
ArtworkLayer replacedAs(LayerPlacement placement, const TexturedMesh& model, ArtworkLayer layer);

// Returns the layer so that it shows only on surface with a material of this name, such as a face
// of a CAD model. A decal moves into its middle. Throws Error if the model has no such material.
ArtworkLayer movedOnto(const TexturedMesh& model, ArtworkLayer layer, const QString& material);

// Adds a layer above all others. The first layer on a model of one plain colour, without a texture,
// also sets the base colour to white, which needs no ink. Otherwise the whole body would be painted
// in the model's plain colour. Throws Error if there are already mostArtworkLayers.
void addLayer(Artwork& artwork, const ArtworkLayer& layer, const TexturedMesh& model);

// Returns the size at which a layer's content appears within its area. A picture or text that is
// shown once keeps its proportions. Text needs a QGuiApplication.
std::array<Millimetres, 2> shownSize(const ArtworkLayer& layer);

// Returns a sentence for each visible layer whose font is not installed and is replaced by another,
// and for each whose text has characters that no installed font has. Those are printed as boxes.
// Text needs a QGuiApplication.
QStringList fontWarnings(const Artwork& artwork);
// Returns a sentence for each visible layer around an axis of the model that is longer than a turn,
// so that its sides are cut off. Repeats continue, so nothing of them is lost. Also returns a
// sentence for each visible decal of which a part is lost, because another body of the model covers
// the surface: a decal does not continue on another body. Text needs a QGuiApplication.
QStringList cutOffWarnings(const Artwork& artwork, const TriangleMesh& mesh);
// Returns the note on how a layer's picture was read (base/ColourNote.h), without the last full
// stop; empty if there is none.
QString colourNoteOf(const ArtworkLayer& layer);
// Returns colourNoteOf() of all layers that have one, and a note for each layer whose spot ink has
// another colour or printing order than in a layer below, because the lowest layer decides.
QStringList layerNotes(const Artwork& artwork);

} // namespace dipwright
