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

struct SheetTile {
    QRectF box;              // in page coordinates, mm
    int row = 0, column = 0; // counted from 0
};

// Returns the tiles row by row, without those on which nothing would be printed. Each tile is as
// large as the paper within the margins, less a strip at its foot. The strip has the tile's label
// and, if the sheet has a ruler, a ruler. The sheet's own ruler and job line are left out, because
// tiles would cut them. Throws Error if the paper has no room beyond the overlap, or if more than
// 400 tiles are needed.
std::vector<SheetTile> sheetTiles(const Sheet& sheet, const TileSettings& settings);

// Draws one tile onto its paper: the image within the margins, cut lines to the next tiles, ruler
// and label. The label has the job number, the tile's place, the project and the dip. The painter's
// unit is the millimetre, its origin the paper's upper left corner.
void paintTile(QPainter& painter, const Sheet& sheet, const TileSettings& settings,
               const SheetTile& tile);

// Writes a PDF with one page per tile. The same sheet gives the same bytes. Throws Error.
void writeTiledPdf(const Sheet& sheet, const TileSettings& settings, QIODevice& device,
                   const PrintCorrection& correction = {});

} // namespace dipwright
