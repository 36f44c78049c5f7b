// Which of a body's surface a cradle may come near.
#pragma once

#include "base/Progress.h"
#include "cradle/CradleCheck.h"
#include "dip/LaidFilm.h"
#include "settings/CradleSettings.h"

#include <optional>

namespace dipwright {

// A body's surface in small pieces, parted by what dips do to it. Pose frame of this dip.
struct FilmSide {
    // What this dip's film reaches, or could: all that it paints, and every face under the final
    // waterline that does not turn up by more than the overhang.
    TriangleMesh film;
    TriangleMesh earlierPaint; // what earlier dips paint of the rest
    // What may lie on a cradle: visible from above, far enough from the two.
    std::vector<SeatPiece> seat;
};

// `edge`: mm, about the longest side of a piece. `filmDistance` from the film, `earlierDistance`
// from earlier paint; none: it may be touched.
FilmSide filmSide(const LaidFilm& film, const std::vector<const LaidFilm*>& earlier,
                  const ProcessSettings& process, double edge, double filmDistance,
                  std::optional<double> earlierDistance, const Progress& progress);

} // namespace dipwright
