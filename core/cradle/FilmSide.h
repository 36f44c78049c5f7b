// Finds the parts of a body's surface that a cradle may touch.
#pragma once

#include "base/Progress.h"
#include "cradle/CradleCheck.h"
#include "dip/LaidFilm.h"
#include "marks/SurfaceMask.h"
#include "settings/CradleSettings.h"

#include <optional>

namespace dipwright {

// A body's surface, for the cradle of one dip ("this dip"). The surface is cut into small pieces.
// They are grouped by what paints them: this dip, earlier dips, or nothing. Coordinates are in this
// dip's pose frame.
struct FilmSide {
    // The surface that this dip's film reaches or may reach: all that it paints, and every face
    // that turns up by no more than the overhang when it goes under water. Masked surface is
    // covered with tape, so it counts as dry.
    TriangleMesh film;
    TriangleMesh earlierPaint; // the rest of the surface that earlier dips paint
    // The pieces that may lie on a cradle: visible from above, and far enough from `film` and
    // `earlierPaint`.
    std::vector<SeatPiece> seat;
};

// Sorts the surface. `edge` is the longest side of a piece, mm. The seat keeps `filmDistance` from
// the film and `earlierDistance` from earlier paint, mm. Without `earlierDistance` the seat may
// touch earlier paint.
// `mask` may be null.
FilmSide filmSide(const LaidFilm& film, const std::vector<const LaidFilm*>& earlier,
                  const SurfaceMask* mask, const ProcessSettings& process, double edge,
                  double filmDistance, std::optional<double> earlierDistance,
                  const Progress& progress);

} // namespace dipwright
