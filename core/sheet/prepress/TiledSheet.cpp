#include "sheet/prepress/TiledSheet.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/SheetInk.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/SheetFiles.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

constexpr int mostTiles = 400;
constexpr double labelDepth = 4; // mm at the foot of each tile, kept for its label
constexpr double footGap = 1;    // mm between tile and ruler

double footDepth(const Sheet& sheet) {
    return sheet.settings.ruler ? labelDepth + rulerDepth + footGap : labelDepth;
}

// Returns the part of the paper that a tile fills.
QRectF innerBox(const Sheet& sheet, const TileSettings& settings) {
    return QRectF({0, 0}, settings.paper)
        .marginsRemoved(settings.margins)
        .adjusted(0, 0, 0, -footDepth(sheet));
}

int tileCount(double length, double tile, double overlap) {
    return std::max(1, int(std::ceil((length - overlap) / (tile - overlap) - 1e-9)));
}

struct TileGrid {
    int columns = 1;
    int rows = 1;
};

TileGrid tileGrid(const Sheet& sheet, const TileSettings& settings) {
    const QSizeF page = pageSize(sheet);
    const QSizeF inner = innerBox(sheet, settings).size();
    if (inner.width() <= settings.overlap || inner.height() <= settings.overlap) {
        throw Error(
            Text::tr("Paper of %1 × %2 mm is too small for a tile of the sheet; use larger paper")
                .arg(settings.paper.width())
                .arg(settings.paper.height()),
            QStringLiteral("tiles"));
    }
    const TileGrid grid{tileCount(page.width(), inner.width(), settings.overlap),
                        tileCount(page.height(), inner.height(), settings.overlap)};
    if (grid.columns > mostTiles || grid.rows > mostTiles || grid.columns * grid.rows > mostTiles) {
        throw Error(Text::tr("The sheet needs more than %1 pages of this paper; use larger paper")
                        .arg(mostTiles),
                    QStringLiteral("tiles"));
    }
    return grid;
}

// Paints the lines in the middle of the overlap, where neighbours are cut.
void paintCutLines(QPainter& painter, const QRectF& inner, const TileGrid& grid,
                   const SheetTile& tile, double overlap) {
    painter.setPen(QPen(Qt::black, hairline, Qt::DashLine));
    const auto across = [&](double x) {
        painter.drawLine(QPointF(x, inner.top() - 3), QPointF(x, inner.top() + 3));
        painter.drawLine(QPointF(x, inner.bottom() - 3), QPointF(x, inner.bottom() + 3));
    };
    const auto along = [&](double y) {
        painter.drawLine(QPointF(inner.left() - 3, y), QPointF(inner.left() + 3, y));
        painter.drawLine(QPointF(inner.right() - 3, y), QPointF(inner.right() + 3, y));
    };
    if (tile.column > 0) {
        across(inner.left() + overlap / 2);
    }
    if (tile.column + 1 < grid.columns) {
        across(inner.right() - overlap / 2);
    }
    if (tile.row > 0) {
        along(inner.top() + overlap / 2);
    }
    if (tile.row + 1 < grid.rows) {
        along(inner.bottom() - overlap / 2);
    }
}

// Returns the sheet without the items that tiles would cut.
Sheet withoutStrips(const Sheet& sheet) {
    Sheet bare = sheet;
    bare.settings.ruler = bare.settings.jobLine = false;
    return bare;
}

// Tells whether anything is printed in a box on the page. With a cut contour, the whole film counts
// as printed.
bool isPrinted(const Sheet& sheet, const SheetLayout& layout, const QRectF& box) {
    const auto touches = [&](const auto& item) { return item.box().intersects(box); };
    return std::any_of(layout.marks.begin(), layout.marks.end(), touches) ||
           std::any_of(layout.pieces.begin(), layout.pieces.end(), touches) ||
           (sheet.settings.cutLine != CutLine::None && layout.film.intersects(box)) ||
           inkedShare(sheet, layout.film, box) > 0;
}

void paintFoot(QPainter& painter, const Sheet& sheet, const QRectF& inner, const TileGrid& grid,
               const SheetTile& tile, double overlap) {
    const double left = inner.left() + overlap / 2 + 2; // beside the cut line
    const double room = inner.right() - overlap / 2 - 2 - left;
    const int length = std::min(100, int((room - 2 * rulerEndRoom) / 10) * 10);
    if (sheet.settings.ruler && length > 0) {
        paintRuler(painter,
                   {{left, inner.bottom() + footGap}, 0, {length + 2 * rulerEndRoom, rulerDepth}});
    }
    const QString label =
        Text::tr("Row %2 of %3, column %4 of %5 · job %1 · %6 · %7 · cut along the dashed lines")
            .arg(sheet.job.hash.simplified())
            .arg(tile.row + 1)
            .arg(grid.rows)
            .arg(tile.column + 1)
            .arg(grid.columns)
            .arg(nameOnPaper(sheet.job.project), nameOnPaper(sheet.job.immersion));
    const QString fitting =
        QFontMetricsF(sheetFont(jobLineType)).elidedText(label, Qt::ElideRight, room / typeUnit);
    SheetInk(painter, false)
        .text({left, inner.bottom() + footDepth(sheet) - 1}, jobLineType, fitting);
}

} // namespace

std::vector<SheetTile> sheetTiles(const Sheet& sheet, const TileSettings& settings) {
    const TileGrid grid = tileGrid(sheet, settings);
    const QSizeF inner = innerBox(sheet, settings).size();
    const SheetLayout layout = sheetLayout(withoutStrips(sheet));
    std::vector<SheetTile> tiles;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const QPointF corner(column * (inner.width() - settings.overlap),
                                 row * (inner.height() - settings.overlap));
            const SheetTile tile{{corner, inner}, row, column};
            if (isPrinted(sheet, layout, tile.box)) {
                tiles.push_back(tile);
            }
        }
    }
    if (tiles.empty()) {
        tiles.push_back({{{0, 0}, inner}});
    }
    return tiles;
}

void paintTile(QPainter& painter, const Sheet& sheet, const TileSettings& settings,
               const SheetTile& tile) {
    const TileGrid grid = tileGrid(sheet, settings);
    const QRectF inner = innerBox(sheet, settings);
    painter.save();
    painter.setClipRect(inner);
    painter.translate(inner.topLeft() - tile.box.topLeft());
    paintSheet(painter, withoutStrips(sheet));
    painter.restore();
    painter.save();
    paintCutLines(painter, inner, grid, tile, settings.overlap);
    paintFoot(painter, sheet, inner, grid, tile, settings.overlap);
    painter.restore();
}

void writeTiledPdf(const Sheet& sheet, const TileSettings& settings, QIODevice& device,
                   const PrintCorrection& correction) {
    const PreparedSheet prepared = preparedSheet(sheet, correction);
    std::vector<PdfPage> pages;
    for (const SheetTile& tile : sheetTiles(sheet, settings)) {
        pages.push_back({settings.paper, [&, tile](QPainter& painter) {
                             correctScale(painter, settings.paper, correction);
                             paintTile(painter, prepared.sheet, settings, tile);
                         }});
    }
    const QByteArray pdf = pdfDocument(pages, prepared.settings);
    writeTo(device, pdf, Text::tr("The sheet's PDF cannot be written: %1"),
            QStringLiteral("sheet.pdf"));
}

} // namespace dipwright
