// What is printed round each of several jobs on one film.
#pragma once

#include "sheet/page/Sheet.h"

#include <QPainter>

namespace dipwright {

inline constexpr double pieceFoot = 12;       // mm under the marks: code and job line
inline constexpr double leastPieceWidth = 40; // mm, for the job line to have room

// What the code of a piece says: the job, the dip and the copy, as in "b7b773909db3/1/2".
QString pieceCode(const SheetPiece& piece);

// Cut line, marks, code and job line, and where the middle of its job's own film is. A painter in
// mm, origin the page's upper left corner. Needs a QGuiApplication.
void paintPiece(QPainter& painter, const SheetPiece& piece);

} // namespace dipwright
