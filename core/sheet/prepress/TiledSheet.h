// A sheet that is larger than the paper, in overlapping pieces to be laid edge to edge.
#pragma once

#include "sheet/page/Sheet.h"

#include <QIODevice>
#include <QMarginsF>
#include <vector>

namespace dipwright {

struct TileSettings {
    QSizeF paper{210, 297};        // mm
    QMarginsF margins{5, 5, 5, 5}; // of the paper, that stay white but for the labels
    double overlap = 10;           // mm that neighbours share
};

// The pieces of the page, in its mm, row by row; each as large as the paper within the margins,
// less a strip at its foot for the label. Throws Error when the paper leaves no more than the
// overlap, or more than 400 pieces were needed.
std::vector<QRectF> sheetTiles(const Sheet& sheet, const TileSettings& settings);

// Draws one piece onto its paper: the piece within the margins, cut lines where the next one joins,
// and which piece it is. A painter in mm, origin the paper's upper left corner.
void paintTile(QPainter& painter, const Sheet& sheet, const TileSettings& settings, int index);

// PDF with a page for each piece. Same bytes for the same sheet. Throws Error.
void writeTiledPdf(const Sheet& sheet, const TileSettings& settings, QIODevice& device,
                   const PrintCorrection& correction = {});

} // namespace dipwright
