// Artwork painted onto a body: a model with texture coordinates and one texture, as if it had been
// imported so.
#pragma once

#include "base/Progress.h"
#include "model/TexturedMesh.h"
#include "settings/Artwork.h"

#include <memory>

namespace dipwright {

// The model with the artwork on it: the same triangles and materials, but charts of its own
// (Unwrap.h) and one opaque picture, sRGB or, where the model's texture or a layer's picture is so,
// wide. Below all layers lies the artwork's base colour or else what the model shows itself.
// Layers cover each other in linear light. `texel`: mm on the body, at best; coarser where
// Budgets.h allows no more, or `mostTexels` (> 0) does not. All cores, the same bits in every run;
// throws Cancelled. Layers of text need a QGuiApplication.
TexturedMesh paintArtwork(const TexturedMesh& model, const Artwork& artwork, double texel,
                          const Progress& progress, qint64 mostTexels = 0);

// What the model is to show of a spot ink, as its plate: grey, the tint being 1 − its linear light.
// Only what a layer covers counts, and not in which colour.
SurfaceAppearance paintSpot(const TexturedMesh& model, const Artwork& artwork, const QString& spot,
                            double texel, const Progress& progress);

// paintArtwork() for models that are shared; one without artwork comes back as it is.
std::shared_ptr<const TexturedMesh> painted(const std::shared_ptr<const TexturedMesh>& model,
                                            const Artwork& artwork, double texel,
                                            const Progress& progress, qint64 mostTexels = 0);

// Texels of about this size lose nothing that a sheet of this resolution shows, mm.
double texelFor(DotsPerInch resolution);

} // namespace dipwright
