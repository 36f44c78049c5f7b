// Makes a chessboard sheet and measures its squares after printing.
#pragma once

#include "sheet/page/Sheet.h"

#include <vector>

namespace dipwright {

// Returns a sheet with squares of 17 mm over the whole film, and a coloured square in the middle.
// `film` is in mm.
Sheet chessSheet(const QString& immersion, QSizeF film = {210, 297});

// Returns the widths, in mm, of the squares along a horizontal line of a received page, or their
// heights along a vertical line. The line avoids the marks and the red square in the middle.
std::vector<double> squares(const QString& path, bool across);

} // namespace dipwright
