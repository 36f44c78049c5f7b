// Paints the cut line, marks and job line of each piece when several jobs share one film.
#pragma once

#include "sheet/page/Sheet.h"

#include <QPainter>

namespace dipwright {

inline constexpr double pieceFoot = 12;       // mm below the marks for the code and the job line
inline constexpr double leastPieceWidth = 40; // mm that the job line needs

// Returns the content of a piece's code: job, dip and copy, as in "b7b773909db3/1/2".
QString pieceCode(const SheetPiece& piece);

// Least gap around a whole sheet, mm, for cut marks. In a smaller gap, a dashed line is drawn along
// the sheet's edge instead.
inline constexpr double leastCutGap = 2;

// Paints the cut line, the marks, the code, the job line and the centre of the job's own film. For
// a whole sheet, paints its own marks and, in the gap around it, cut marks and the job's number and
// copy. The painter's unit is the millimetre, its origin the page's upper left corner. Needs a
// QGuiApplication.
void paintPiece(QPainter& painter, const SheetPiece& piece);

} // namespace dipwright
