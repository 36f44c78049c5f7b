// The film picture of the paper's accuracy experiment.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QImage>

namespace dipwright {

// Chess squares of `square` mm, black and white, four of them meeting in the film's middle. Opaque
// Format_RGBA8888; a pixel takes the colour of the square its centre is in.
QImage chessboard(const solver::FilmGrid& grid, double square, QSize pixels);

} // namespace dipwright
