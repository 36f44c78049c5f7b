// Splits a sheet that is larger than the paper into overlapping tiles, to be joined after printing.
#pragma once

#include "sheet/page/Sheet.h"

#include <QIODevice>
#include <QMarginsF>
#include <vector>

namespace dipwright {

struct TileSettings {
    QSizeF paper{210, 297};        // mm
    QMarginsF margins{5, 5, 5, 5}; // mm; tiles stay within the margins of the paper
    double overlap = 10;           // mm that neighbouring tiles share
};

// Returns the tiles in page coordinates, in mm, row by row. Each is as large as the paper within
// the margins, less a strip at its foot for the label. Throws Error if the paper has no room beyond
// the overlap, or if more than 400 tiles are needed.
std::vector<QRectF> sheetTiles(const Sheet& sheet, const TileSettings& settings);

// Draws one tile onto its paper: the image within the margins, cut lines to the next tiles, and the
// tile's label. The painter's unit is the millimetre, its origin the paper's upper left corner.
void paintTile(QPainter& painter, const Sheet& sheet, const TileSettings& settings, int index);

// Writes a PDF with one page per tile. The same sheet gives the same bytes. Throws Error.
void writeTiledPdf(const Sheet& sheet, const TileSettings& settings, QIODevice& device,
                   const PrintCorrection& correction = {});

} // namespace dipwright
