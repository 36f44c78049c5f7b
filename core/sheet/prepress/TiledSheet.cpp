#include "sheet/prepress/TiledSheet.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "sheet/page/SheetInk.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/SheetFiles.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

constexpr int mostTiles = 400;
constexpr double labelDepth = 4; // mm at the foot of each tile, kept for its label

// Returns the part of the paper that a tile fills.
QRectF innerBox(const TileSettings& settings) {
    return QRectF({0, 0}, settings.paper)
        .marginsRemoved(settings.margins)
        .adjusted(0, 0, 0, -labelDepth);
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
    const QSizeF inner = innerBox(settings).size();
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
void paintCutLines(QPainter& painter, const QRectF& inner, const TileGrid& grid, int index,
                   double overlap) {
    const int column = index % grid.columns;
    const int row = index / grid.columns;
    painter.setPen(QPen(Qt::black, hairline, Qt::DashLine));
    const auto across = [&](double x) {
        painter.drawLine(QPointF(x, inner.top() - 3), QPointF(x, inner.top() + 3));
        painter.drawLine(QPointF(x, inner.bottom() - 3), QPointF(x, inner.bottom() + 3));
    };
    const auto along = [&](double y) {
        painter.drawLine(QPointF(inner.left() - 3, y), QPointF(inner.left() + 3, y));
        painter.drawLine(QPointF(inner.right() - 3, y), QPointF(inner.right() + 3, y));
    };
    if (column > 0) {
        across(inner.left() + overlap / 2);
    }
    if (column + 1 < grid.columns) {
        across(inner.right() - overlap / 2);
    }
    if (row > 0) {
        along(inner.top() + overlap / 2);
    }
    if (row + 1 < grid.rows) {
        along(inner.bottom() - overlap / 2);
    }
}

} // namespace

std::vector<QRectF> sheetTiles(const Sheet& sheet, const TileSettings& settings) {
    const TileGrid grid = tileGrid(sheet, settings);
    const QSizeF inner = innerBox(settings).size();
    std::vector<QRectF> tiles;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            tiles.emplace_back(QPointF(column * (inner.width() - settings.overlap),
                                       row * (inner.height() - settings.overlap)),
                               inner);
        }
    }
    return tiles;
}

void paintTile(QPainter& painter, const Sheet& sheet, const TileSettings& settings, int index) {
    const TileGrid grid = tileGrid(sheet, settings);
    const QRectF tile = sheetTiles(sheet, settings).at(std::size_t(index));
    const QRectF inner = innerBox(settings);
    painter.save();
    painter.setClipRect(inner);
    painter.translate(inner.topLeft() - tile.topLeft());
    paintSheet(painter, sheet);
    painter.restore();
    painter.save();
    paintCutLines(painter, inner, grid, index, settings.overlap);
    const QString label =
        Text::tr("%1 · row %2 of %3, column %4 of %5 · cut along the dashed lines")
            .arg(sheet.job.immersion.simplified())
            .arg(index / grid.columns + 1)
            .arg(grid.rows)
            .arg(index % grid.columns + 1)
            .arg(grid.columns);
    const double besideCutLine = settings.overlap / 2 + 2;
    SheetInk(painter, false)
        .text({inner.left() + besideCutLine, inner.bottom() + labelDepth - 1}, 2.2, label);
    painter.restore();
}

void writeTiledPdf(const Sheet& sheet, const TileSettings& settings, QIODevice& device,
                   const PrintCorrection& correction) {
    const PreparedSheet prepared = preparedSheet(sheet, correction);
    std::vector<PdfPage> pages;
    for (int index = 0; index < int(sheetTiles(sheet, settings).size()); ++index) {
        pages.push_back({settings.paper, [&, index](QPainter& painter) {
                             correctScale(painter, settings.paper, correction);
                             paintTile(painter, prepared.sheet, settings, index);
                         }});
    }
    const QByteArray pdf = pdfDocument(pages, prepared.settings);
    writeTo(device, pdf, Text::tr("The sheet's PDF cannot be written: %1"),
            QStringLiteral("sheet.pdf"));
}

} // namespace dipwright
