// Paints artwork onto a body. The result is a model with texture coordinates and one texture, like
// an imported model.
#pragma once

#include "base/Progress.h"
#include "model/TexturedMesh.h"
#include "settings/Artwork.h"

#include <memory>

namespace dipwright {

// Returns the model with the artwork on it: the same triangles and materials, with new charts
// (Unwrap.h) and one opaque picture.
// The picture is wide if the model's texture or a layer's picture is; otherwise it is sRGB. Below
// all layers is the artwork's base colour or, without one, the model's own appearance. Layers are
// blended in linear light.
// `texel` is the texel size on the body, mm. It grows if Budgets.h or `mostTexels` (if > 0) allows
// fewer texels. Uses all cores; every run gives the same bits. Throws Cancelled. Text layers need a
// QGuiApplication.
TexturedMesh paintArtwork(const TexturedMesh& model, const Artwork& artwork, double texel,
                          const Progress& progress, qint64 mostTexels = 0);

// Returns the plate of a spot colour on the model, in grey. The tint is 1 − linear light. Only the
// coverage of layers counts, not their colours.
SurfaceAppearance paintSpot(const TexturedMesh& model, const Artwork& artwork, const QString& spot,
                            double texel, const Progress& progress);

// Calls paintArtwork() for a shared model. Returns the model itself if there is no artwork.
std::shared_ptr<const TexturedMesh> painted(const std::shared_ptr<const TexturedMesh>& model,
                                            const Artwork& artwork, double texel,
                                            const Progress& progress, qint64 mostTexels = 0);

// Returns the texel size in mm at which a sheet of this resolution shows no loss of detail.
double texelFor(DotsPerInch resolution);

} // namespace dipwright
