// Measures where the sheets of two dips of one body differ.
#pragma once

#include "accuracy/error/SheetChange.h"
#include "geometry/RefinedMesh.h"

namespace dipwright {

// Returns how far each film point of `own` moves between two films of one body, in mm on the flat
// film: 0 off the body, NaN where only `own` paints the body.
std::vector<float> pointMoves(const LaidFilm& own, const LaidFilm& other);

// How far the place of the flat film that colours a place of the body differs between two dips. The
// poses of the body may differ. Places are in mm from the middle of each film.
struct SheetDifference {
    std::vector<float> pieces; // sheetMoves() in the middle of each triangle of the fine body
    std::vector<float> points; // pointMoves() of the second film
    SheetChange change;        // at comparedPlaces()
    SurfacePoint farthest;     // the compared place that moves most; invalid: both paint none
};

// Compares two films of one body; `fine` is fineBody() of it. Uses all cores; deterministic.
SheetDifference sheetDifference(const LaidFilm& first, const LaidFilm& second,
                                const RefinedMesh& fine);

} // namespace dipwright
