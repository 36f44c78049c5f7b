// Makes the film image of the accuracy experiment in the 2020 paper.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QImage>

namespace dipwright {

// Edge length of the squares on the sheet in that experiment, mm.
inline constexpr double chessSquare = 17;

// Returns black and white squares of `square` mm, four of which meet in the film's middle. Opaque
// Format_RGBA8888. Pixels on a border have a grey in proportion to their black and white parts.
QImage chessboard(const solver::FilmGrid& grid, double square, QSize pixels);

} // namespace dipwright
