// Finds the surface that stays bare because the film tore before it reached this surface.
#pragma once

#include "base/Units.h"
#include "dip/LaidFilm.h"

#include <vector>

namespace dipwright {

// The torn film of a dip. The body passes through the tear, so its surface above the tear stays
// bare, even if a later part of the body lands on the torn film. For example, the inside of a cup
// stays bare, although the cup's bottom lands on torn film. Immutable; any thread may read. Keeps a
// reference to the film.
class TornFilm {
public:
    // Faces that turn up by more than `overhang` hold no film.
    TornFilm(const LaidFilm& laid, Degrees overhang);

    bool isNone() const { return squares_.empty(); }
    // Whether film could adhere to a place of the body: it does not turn up too far, is under water
    // and not dry, and if it turns down, nothing of the body lies below it.
    bool isInReach(const SurfacePoint& place) const;
    // Whether torn film lies vertically above or below the place, or at most one cell beside it.
    bool isAt(const SurfacePoint& place) const;

private:
    const LaidFilm& laid_;
    float steepest_;  // largest y component of the normal of a face that holds film
    float water_ = 0; // height of the water in the pose frame, mm
    // Squares of one film cell, row by row, that torn film touches or is next to; empty if no film
    // tore.
    std::vector<std::uint8_t> squares_;
    Eigen::AlignedBox2f area_; // X and Z of the squares, mm
    int columns_ = 0;
    float square_ = 1; // mm
};

} // namespace dipwright
