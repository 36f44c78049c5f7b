// How far the film that paints is stretched. Film that hangs off the body between adhered and free
// points has no meaning of its own and would drown these figures.
#pragma once

#include "dip/FilmContact.h"
#include "film/DippedFilm.h"

namespace dipwright {

// How film on the body is compressed: its smaller principal stretch λ2 is below 1, against the film
// as it floated when it was touched (compression()). The model lets it thicken; real film may fold
// there (docs/film-model.md, "Measures").
struct Wrinkling {
    std::vector<float> pointStretches; // a film point each: mean λ2 of its painted triangles; or 1
    double area = 0;                   // mm² of flat film with λ2 below wrinkledBelow
    double share = 0;                  // of the painted film
    double least = 1;                  // the smallest λ2
};
inline constexpr float wrinkledBelow =
    0.99f; // a hundredth is within what a film profile is known to

struct PaintedStretch {
    std::vector<std::uint8_t> points; // a film point each: 1 where painted film meets in it
    // Final over rest length of the horizontal and vertical constraints that are sides of painted
    // film, and for each film point the mean of those that meet in it; 1 where none does.
    std::vector<float> constraints, pointMeans;
    std::vector<float> areas; // area stretch J of the painted film triangles
    Wrinkling wrinkling;
};

// `triangles` and `stretches`: filmTriangles() and principalStretches() of the film.
PaintedStretch paintedStretch(const DippedFilm& film, const std::vector<FilmTriangle>& triangles,
                              const std::vector<PrincipalStretch>& stretches,
                              const FilmContact& contact);

// J for each film point: the mean of the painted triangles round it, so that the ink's density,
// which is reckoned with it, does not jump from triangle to triangle. Where these lie on one side
// only, and at points past the limit of contact, it tends to what a linear function through the
// painted triangles near by says there (patch recovery, Zienkiewicz & Zhu 1992), as far as one
// explains them; 1 where no film that paints is near.
std::vector<float> paintedPointAreas(const DippedFilm& film,
                                     const std::vector<FilmTriangle>& triangles,
                                     const std::vector<PrincipalStretch>& stretches,
                                     const FilmContact& contact);

} // namespace dipwright
