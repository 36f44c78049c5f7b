// From the body's texture back to the image to print.
//
// Film images are pictures of the flat film, ink side up: pixel columns run along +X, pixel rows
// along +Z; the picture's full width is the film's width (docs/film-model.md, "Which way up the
// sheet is").
#pragma once

#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"
#include "settings/InkSettings.h"
#include "texture/PaintShare.h"

#include <QImage>

#include <functional>

namespace dipwright {

// What the body is to show in a spot ink: grey of 1 − its tint in linear light.
using SpotAppearance = std::function<SurfaceAppearance()>;

struct ReverseTextureOptions {
    QSize pixels;     // of the whole film
    double bleed = 2; // mm that the colour is continued past the painted area
    InkSettings ink;
    std::optional<PaintShare> share = {}; // none: it gives all the colour wherever it reaches
    double white = 0; // tint that a white layer is to have on the body, 0 … 1; 0: no layer
    bool keepsWanted = false; // what colour is to show, and how far the film stretches there
    // Made when their turn comes, one at a time: each is as large as the body's texture.
    std::vector<SpotAppearance> spots = {};
};

struct ReverseTexture {
    QImage image; // alpha 0 where nothing is printed; wide where a texture is, else
                  // RGBA8888 in sRGB
    std::size_t seamTriangles = 0; // film triangles that crossed from chart to chart
    double shortfallArea = 0; // mm² of body whose density cannot be reached within the ink limit
    // The tint of white to print wherever there is colour, more where the film stretches, as far as
    // full tint goes; of the image's size, Grayscale8. Null where none is wanted.
    QImage white;
    // What the image is to show on the body, as it would be printed on film that is not stretched,
    // and how far it is: Grayscale16, codes of StretchPlane.h. Null where they are not kept.
    QImage wanted, stretch;
    // The tints of the spot inks, in the options' order; of the image's size, Grayscale8. Tint
    // thins as an even layer, and shares of it are shares of tint.
    std::vector<QImage> spots;
};

// The image to print so that the dip puts `appearance` where it belongs on the body: every pixel in
// a painted film triangle shows its place of the texture, filtered over what the pixel covers
// there. Where its share is nothing the film is left blank, and no colour is continued there. All
// cores, deterministic, throws Cancelled; Error for an image that does not fit into memory.
ReverseTexture reverseTexture(const LaidFilm& laid, const SurfaceAppearance& appearance,
                              const ReverseTextureOptions& options, const Progress& progress);

} // namespace dipwright
