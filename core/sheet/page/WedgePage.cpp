#include "sheet/page/WedgePage.h"

#include "base/Error.h"
#include "sheet/page/DrawnPage.h"
#include "sheet/page/Sheet.h"
#include "sheet/page/SheetInk.h"

#include <QCoreApplication>
#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::WedgePage)
};

constexpr double margin = 12;     // mm around the page
constexpr double headHeight = 46; // mm above the first row, for text and tones
constexpr double nameWidth = 20;  // mm left of each row
constexpr double gap = 8;         // mm between rows, for handwriting
constexpr double mostPatch = 14;  // largest side of a patch, mm
constexpr double leastPatch = 8;  // least side, mm: room for a densitometer's opening

double patchSize(const WedgePage& page) {
    std::size_t most = 1;
    for (const WedgeRow& row : page.rows) {
        most = std::max(most, row.patches.size());
    }
    const double wide = (page.paper.width() - 2 * margin - nameWidth) / double(most);
    // The upright ruler also needs room below the rows.
    const double high = (page.paper.height() - headHeight - 2 * margin - rulerDepth) /
                            double(std::max<std::size_t>(page.rows.size(), 1)) -
                        gap;
    const double size = std::min({wide, high, mostPatch});
    const double rulers = wedgeRuler + 2 * rulerEndRoom;
    if (size < leastPatch || page.paper.width() < rulers + 2 * margin ||
        page.paper.height() < headHeight + rulers + margin) {
        throw Error(Text::tr("Paper of %1 × %2 mm is too small for the wedge; use larger paper")
                        .arg(page.paper.width())
                        .arg(page.paper.height()),
                    QStringLiteral("paper"));
    }
    return size;
}

QString titleOf() {
    return Text::tr("Step wedge: print this page on the film like a sheet");
}

void paintWords(const SheetInk& ink, const WedgePage& page) {
    const QString open = QString(16, QLatin1Char('_'));
    const auto given = [&](const QString& text) { return text.isEmpty() ? open : text; };
    const QStringList words{
        Text::tr("1. Zero the densitometer on unprinted film. Read every patch before the dip."),
        Text::tr("2. Stretch the floating film by a dip or by hand. Measure both rulers (%1 mm if "
                 "not stretched).")
            .arg(wedgeRuler),
        Text::tr("3. Read every patch again. Repeat with 3 or 4 stretches, up to the largest "
                 "stretch of the job."),
        Text::tr("Date %1   Lot %2").arg(given(page.date), given(page.lot))};
    double y = margin + 3;
    ink.text({margin, y}, 4.5, titleOf());
    for (const QString& text : words) {
        y += 6;
        ink.text({margin, y}, 3, text);
    }
}

void paintWedge(QPainter& painter, const WedgePage& page) {
    painter.setRenderHint(QPainter::Antialiasing);
    const SheetInk ink(painter, false);
    paintWords(ink, page);
    const double size = patchSize(page);
    const double left = margin + nameWidth;
    ink.text({margin, headHeight - 2}, 2.4, Text::tr("density"));
    for (int column = 0; column < page.tones.size(); ++column) {
        ink.text({left + column * size + 1, headHeight - 2}, 2.4, page.tones[column]);
    }
    double top = headHeight;
    for (const WedgeRow& row : page.rows) {
        ink.text({margin, top + size / 2 + 1}, 3, row.name);
        double x = left;
        for (const QColor& patch : row.patches) {
            painter.fillRect(QRectF(x, top, size, size), patch);
            x += size;
        }
        top += size + gap;
    }
    const QSizeF ruler(wedgeRuler + 2 * rulerEndRoom, rulerDepth);
    paintRuler(painter, {{left, top}, 0, ruler, false});
    // The ruler beside the rows reads upwards.
    const double bottom = std::min(headHeight + ruler.width(), page.paper.height() - margin / 2);
    paintRuler(painter, {{margin / 2, bottom}, -90, ruler, false});
}

DrawnPage drawnPage(const WedgePage& page) {
    patchSize(page);
    return {titleOf(),
            page.paper,
            page.scaleX,
            page.scaleY,
            [page](QPainter& painter) { paintWedge(painter, page); },
            page.inks,
            page.inksName};
}

} // namespace

void writeWedgePdf(const WedgePage& page, QIODevice& device) {
    writeDrawnPdf(drawnPage(page), device);
}

void writeWedgePng(const WedgePage& page, DotsPerInch resolution, QIODevice& device) {
    writeDrawnPng(drawnPage(page), resolution, device);
}

} // namespace dipwright
