// Measures how much of the body one or several dips paint.
#pragma once

#include "base/Progress.h"
#include "base/Units.h"
#include "dip/FilmMarks.h"
#include "dip/TrappedAir.h"
#include "marks/SurfaceMask.h"

#include <optional>

namespace dipwright {

struct Coverage {
    // Per body triangle: 1 if at least half of its surface that is not buried is painted or masked.
    std::vector<std::uint8_t> covered;
    // Per body triangle: the solver::PointMark bits that apply to at least half of its painted
    // area.
    std::vector<std::uint8_t> marks;
    double unburied = 0;    // mm² of the whole surface without buried surface
    double paintedArea = 0; // mm²
    MarkedArea marked;      // the part of paintedArea that marked film paints
    double tornBare = 0;    // mm² of bare surface that would be painted if the film had not torn
    double share = 0;       // painted share of the surface that is not masked, 0 … 1
    TrappedAir trappedAir;  // air pockets, whose walls film cannot reach

    // Returns tornBare as a share of the surface that would be painted then; 0 if there is none.
    double tornBareShare() const { return tornBare > 0 ? tornBare / (paintedArea + tornBare) : 0; }
};

// Computes the coverage of one dip from samples: about four per film cell area, at least one per
// body triangle. Masked and buried surface counts neither as painted nor as bare; `mask` may be
// null. `overhang` is ProcessSettings::overhang; without it, tornBare is not measured. Uses all
// cores; deterministic.
Coverage coverage(const LaidFilm& laid, const SurfaceMask* mask = nullptr,
                  std::optional<Degrees> overhang = {});

// Returns the share of the surface that at least one of the films paints, from evenly spread
// samples, without masked and buried surface. All films must be of the same body. Throws Cancelled.
double coverageTogether(const std::vector<std::shared_ptr<const LaidFilm>>& films,
                        const Progress& progress, const SurfaceMask* mask = nullptr);

} // namespace dipwright
