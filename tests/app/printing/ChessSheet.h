// A sheet that can be measured when it has been printed.
#pragma once

#include "sheet/page/Sheet.h"

#include <vector>

namespace dipwright {

// 17 mm squares over a film, with a coloured one in the middle.
Sheet chessSheet(const QString& immersion, QSizeF film = {210, 297});

// In mm on a page as received: widths of the squares along a line across it, or heights along one
// down it, off the middle, where the red square is, and away from the marks.
std::vector<double> squares(const QString& path, bool across);

} // namespace dipwright
