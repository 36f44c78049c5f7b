// Makes a sheet whose size can be measured after printing, and measures it.
#pragma once

#include "sheet/page/Sheet.h"

#include <vector>

namespace dipwright {

// Returns a sheet of 17 mm squares over the film, with a coloured square in the middle. `film`: mm.
Sheet chessSheet(const QString& immersion, QSizeF film = {210, 297});

// Returns the widths of the squares along a horizontal line of a received page, or the heights
// along a vertical line, in mm. The line avoids the marks and the red square in the middle.
std::vector<double> squares(const QString& path, bool across);

} // namespace dipwright
