// From the body's texture back to the image to print.
//
// Film images are pictures of the flat film, ink side up: pixel columns run along +X, pixel rows
// along +Z; the picture's full width is the film's width (docs/film-model.md, "Which way up the
// sheet is").
#pragma once

#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "settings/InkSettings.h"
#include "texture/PaintShare.h"

#include <QImage>

namespace dipwright {

struct ReverseTextureOptions {
    QSize pixels;     // of the whole film
    double bleed = 2; // mm that the colour is continued past the painted area
    InkSettings ink;
    std::optional<PaintShare> share = {}; // none: it gives all the colour wherever it reaches
    double white = 0; // tint that a white layer is to have on the body, 0 … 1; 0: no layer
    bool keepsWanted = false; // what colour is to show, and how far the film stretches there
    // The body shows a plate, in grey of 1 − its tint in linear light; so does the image then. Tint
    // thins as an even layer, and shares of it are shares of tint.
    bool isPlate = false;
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
    std::vector<QImage> spots; // the tints of other plates, of its size, Grayscale8; by the caller
};

// The tints, Grayscale8, of a plate's image.
QImage tintsOf(const QImage& plate);

// The image to print so that the dip puts the body's texture where it belongs: every pixel in a
// painted film triangle shows its place of the texture, filtered over what the pixel covers there.
// Where its share is nothing the film is left blank, and no colour is continued there.
// All cores, deterministic, throws Cancelled; Error for an image that does not fit into memory.
ReverseTexture reverseTexture(const LaidFilm& laid, const ReverseTextureOptions& options,
                              const Progress& progress);

} // namespace dipwright
