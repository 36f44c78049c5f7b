// Measures how much a sheet changes when its dip is simulated with other cells or steps, and sets
// the limits for an accurate sheet.
#pragma once

#include "dip/LaidFilm.h"

namespace dipwright {

// Statistics of how far a sheet changes between two dips. A place on the body takes its colour from
// a place on the flat film; `distance` is how far the place on the film moves.
struct SheetChange {
    Distribution distance;  // mm, at evenly spread points of the body that both dips paint
    double painted = 0;     // share of the body's surface that both dips paint
    double paintedOnce = 0; // share of the body's surface that only one dip paints
};

// Limits for an accurate sheet: for the distance that 95 % of its points keep, and for the surface
// that only one of two dips paints. The second limit allows about one film cell along the border.
inline constexpr double mostHalfStepChange = 0.05;    // mm, with steps half as long
inline constexpr double mostHalfSpacingChange = 0.15; // mm, with film cells half as wide
inline constexpr double mostPaintedOnce = 0.05;       // share of the body's surface

// Tells whether the change is within the limits; false if nothing is painted.
bool isAccurateEnough(const SheetChange& change, double mostDistance);

// Returns points spread evenly over the body's surface, without buried surface, at which sheets are
// compared.
std::vector<SurfacePoint> comparedPlaces(const PosedBody& body);

// Returns how far the film at each of `places` moves between two films of one body in one pose.
// Values are in mm on the flat film, or one of the two constants. Invalid places count as painted
// by neither film. Uses all cores; deterministic.
inline constexpr float paintedByOne = -1, paintedByNeither = -2;
std::vector<float> sheetMoves(const LaidFilm& own, const LaidFilm& other,
                              const std::vector<SurfacePoint>& places);
// Returns `moves` with the marked places of the film `own` (solver::PointMark) set to
// paintedByNeither.
std::vector<float> unmarkedMoves(std::vector<float> moves, const LaidFilm& own,
                                 const std::vector<SurfacePoint>& places);
// Summarises the moves of comparedPlaces().
SheetChange sheetChange(std::vector<float> moves);

} // namespace dipwright
