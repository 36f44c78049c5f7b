// How far a sheet changes when its dip is computed with other numerics, and what a certain sheet
// may change by at most.
#pragma once

#include "dip/LaidFilm.h"

namespace dipwright {

// How far, on the flat film, the places move that the places of the body take their colour from.
struct SheetChange {
    Distribution distance;  // mm, over points spread evenly over the body, where painted both times
    double painted = 0;     // share of the body's surface that is painted both times
    double paintedOnce = 0; // and of what is painted by one of the dips only
};

// What a certain sheet moves by at most, 95 % of it, and how much of the body may be painted by one
// of two dips only: a film cell along the border.
inline constexpr double certainHalfStep = 0.05;    // mm, with steps half as long
inline constexpr double certainHalfSpacing = 0.15; // mm, with film cells half as wide
inline constexpr double certainPaintedOnce = 0.05; // of the body's surface

// False where nothing is painted.
bool isCertain(const SheetChange& change, double mostDistance);

// Points spread evenly over the body, to compare sheets at.
std::vector<SurfacePoint> comparedPlaces(const TriangleMesh& body);

// How far each of `places` of the body moves on the flat film between two films of one body in one
// pose, mm; or one of these. Invalid places count as painted by neither. All cores, deterministic.
inline constexpr float paintedByOne = -1, paintedByNeither = -2;
std::vector<float> sheetMoves(const LaidFilm& own, const LaidFilm& other,
                              const std::vector<SurfacePoint>& places);
// The same where the film of `own` has no mark (solver::PointMark); marked places count as painted
// by neither.
std::vector<float> unmarkedMoves(std::vector<float> moves, const LaidFilm& own,
                                 const std::vector<SurfacePoint>& places);
// Of the moves of comparedPlaces().
SheetChange sheetChange(std::vector<float> moves);

} // namespace dipwright
