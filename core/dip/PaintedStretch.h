// Measures the stretch of the film that paints. Film that hangs off the body between adhered and
// floating points is left out, because it would distort these figures.
#pragma once

#include "dip/FilmContact.h"
#include "film/DippedFilm.h"

namespace dipwright {

// How far film on the body is compressed. Film is compressed if its smaller principal stretch λ2 is
// below 1, relative to the film when it was touched (compression()). The model lets such film
// thicken; real film may wrinkle (docs/film-model.md, "Measures").
struct Wrinkling {
    // Per film point: mean λ2 of its painted triangles; 1 if none.
    std::vector<float> pointStretches;
    double area = 0;  // mm² of flat film with λ2 below wrinkledBelow
    double share = 0; // this area as a share of the film that paints, 0 … 1
    double least = 1; // the smallest λ2
};
// A limit of λ2. It is less than 1 because film profiles are known only to about 1 %.
inline constexpr float wrinkledBelow = 0.99f;

struct PaintedStretch {
    std::vector<std::uint8_t> points; // per film point: 1 if it belongs to a painted triangle
    // `constraints` holds the final length divided by the rest length of each horizontal and
    // vertical constraint along sides of painted triangles. `pointMeans` holds, per film point, the
    // mean over its constraints; 1 if it has none.
    std::vector<float> constraints, pointMeans;
    std::vector<float> areas; // area stretch J of each painted film triangle
    Wrinkling wrinkling;
};

// Measures the painted film. `triangles` and `stretches` are filmTriangles() and
// principalStretches() of the film.
PaintedStretch paintedStretch(const DippedFilm& film, const std::vector<FilmTriangle>& triangles,
                              const std::vector<PrincipalStretch>& stretches,
                              const FilmContact& contact);

// Returns J per cell of the film: the mean of its painted triangles, corrected so that
// interpolation between the middles of cells (LaidFilm::areaStretch) has the right mean over each
// cell. Cells just past the limit of contact get the value of a linear fit through nearby painted
// triangles (patch recovery, Zienkiewicz & Zhu 1992). The better the fit explains those triangles,
// the more weight it has. The result is 1 where no painted film is near.
std::vector<float> paintedCellAreas(const DippedFilm& film,
                                    const std::vector<FilmTriangle>& triangles,
                                    const std::vector<PrincipalStretch>& stretches,
                                    const FilmContact& contact);

} // namespace dipwright
