// Computes the film image to print from the body's texture.
//
// Film images are pictures of the flat film, ink side up. Pixel columns run along +X, pixel rows
// along +Z. The picture's full width is the film's width (docs/film-model.md, "Which way up the
// sheet is").
#pragma once

#include "base/InkPicture.h"
#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "marks/SurfaceMask.h"
#include "model/TexturedMesh.h"
#include "settings/InkSettings.h"
#include "texture/PaintShare.h"

#include <QImage>

#include <functional>

namespace dipwright {

// Makes the body's appearance in one spot ink. It is grey: a tint t becomes the grey 1 − t in
// linear light.
using SpotAppearance = std::function<SurfaceAppearance()>;

// The colours of an appearance, prepared for filtering.
class BodyColours;
// Prepares the colours. Keeps a reference to the appearance. Uses all cores. Any thread may read
// the result.
std::shared_ptr<const BodyColours> bodyColours(const SurfaceAppearance& appearance);

struct ReverseTextureOptions {
    QSize pixels;     // size of the whole film's image
    double bleed = 2; // mm by which the colour is continued past the painted area
    InkSettings ink;
    std::optional<PaintShare> share = {}; // none: the film gives the whole colour everywhere
    std::shared_ptr<const SurfaceMask> mask = {}; // stays blank; null: nothing is masked
    double white = 0;           // tint of the white layer on the body, 0 … 1; 0: no layer
    double tolerance = 0.03;    // mm on the body by which the texture may be displaced
    bool returnsWanted = false; // whether to return `wanted` and `stretch`
    // Functions that make each spot appearance only when it is processed, because an appearance is
    // as large as the body's texture.
    std::vector<SpotAppearance> spots = {};
};

struct ReverseTexture {
    QImage image; // alpha 0 where nothing is printed; wide if a texture is, else RGBA8888 in sRGB
    std::size_t seamTriangles = 0; // film triangles that cross a border between charts
    double shortfallArea = 0;      // mm² of body that stay too pale because of the ink limit
    // The tint of the white layer: higher where the film stretches, at most full tint. Same size as
    // `image`, Grayscale8. Null if no white is wanted.
    QImage white;
    // The colours that the body should show, not compensated, and the film's stretch as
    // Grayscale16, in codes of StretchPlane.h. Null if they are not kept.
    QImage wanted, stretch;
    // The tints of the spot inks, in the options' order. Same size as `image`, Grayscale8. Tint
    // thins like an even layer; where two films share a place, each prints a share of the tint.
    std::vector<QImage> spots;
    // The amounts of ink that the body should show, not compensated. Null unless `wanted` is kept
    // and a texture has amounts of ink.
    InkPlanes inks;
};

// Computes the image to print so that the dip puts `appearance` in its place on the body. Each
// pixel in a painted film triangle shows its place of the texture, filtered over the area that the
// pixel covers on the texture. Where this film's share is 0, and on masked surface,
// the film stays blank, and colour is not continued into that area. Uses all cores. Deterministic.
// Throws Cancelled, or Error if the image does not fit into memory.
ReverseTexture reverseTexture(const LaidFilm& laid, const SurfaceAppearance& appearance,
                              const ReverseTextureOptions& options, const Progress& progress);
// The same for colours that several films share.
ReverseTexture reverseTexture(const LaidFilm& laid, const BodyColours& colours,
                              const ReverseTextureOptions& options, const Progress& progress);

} // namespace dipwright
