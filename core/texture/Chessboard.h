// The film picture of the paper's accuracy experiment.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QImage>

namespace dipwright {

// Edge of the squares on the printed sheet, mm (the paper's experiment).
inline constexpr double chessSquare = 17;

// Chess squares of `square` mm, black and white, four of them meeting in the film's middle. Opaque
// Format_RGBA8888; pixels that a border runs through are grey by their shares.
QImage chessboard(const solver::FilmGrid& grid, double square, QSize pixels);

} // namespace dipwright
