#include "sheet/page/CalibrationPage.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "base/NumberText.h"
#include "sheet/page/Sheet.h"
#include "sheet/page/SheetInk.h"
#include "sheet/pdf/PdfDocument.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::CalibrationPage)
};

constexpr double square = 17;     // mm, as in the accuracy experiment
constexpr double headHeight = 34; // mm at the top of the page, for the text
constexpr double shortest = 50;   // mm: length of the shortest useful ruler

double wholeCentimetres(double millimetres) {
    return std::floor(millimetres / 10 + 1e-9) * 10;
}

QString plain(double number) {
    return roundedText(number, 6);
}

QStringList words(const CalibrationPage& page) {
    const CalibrationLengths lengths = calibrationLengths(page);
    const QString asked = Text::tr("From its first to its last line, the horizontal ruler must "
                                   "measure %1 mm and the vertical ruler %2 mm.")
                              .arg(plain(lengths.x.value()), plain(lengths.y.value()));
    const QString then =
        page.verifies()
            ? Text::tr("If a ruler differs by more than 0.2 mm, calibrate the printer again.")
            : Text::tr(
                  "Measure both rulers to 0.1 mm and enter the lengths in the printer's profile.");
    const QString scales =
        page.verifies()
            ? Text::tr("Scale correction: X %1, Y %2").arg(plain(page.scaleX), plain(page.scaleY))
            : Text::tr("No scale correction: X 1, Y 1");
    return {page.printer, scales, asked, then};
}

void paintWords(QPainter& painter, const CalibrationPage& page) {
    const SheetInk ink(painter, false);
    const double left = page.clearance.value();
    double y = left + 5;
    ink.text({left, y}, 5,
             page.verifies() ? Text::tr("Verification of the printer's scale")
                             : Text::tr("Calibration of the printer's scale"));
    for (const QString& line : words(page)) {
        y += 5.2;
        const double natural = QFontMetricsF(sheetFont(3)).horizontalAdvance(line) * typeUnit;
        const double room = page.paper.width() - 2 * left;
        ink.text({left, y}, std::min(3.0, 3.0 * room / std::max(natural, 1.0)), line);
    }
}

// Paints as many squares as fit, at most five by five, in the middle of `room`.
void paintChessboard(QPainter& painter, const QRectF& room) {
    const int columns = std::min(5, int(room.width() / square));
    const int rows = std::min(5, int(room.height() / square));
    const QPointF corner = room.center() - QPointF(columns * square / 2, rows * square / 2);
    for (int row = 0; row < rows; ++row) {
        for (int column = row % 2; column < columns; column += 2) {
            painter.fillRect(
                QRectF(corner + QPointF(column * square, row * square), QSizeF(square, square)),
                Qt::black);
        }
    }
}

} // namespace

CalibrationLengths calibrationLengths(const CalibrationPage& page) {
    const double margins = 2 * page.clearance.value() + 2 * rulerEndRoom;
    const double x = wholeCentimetres(page.paper.width() - margins - rulerDepth);
    const double y = wholeCentimetres(page.paper.height() - margins - headHeight - rulerDepth);
    if (x < shortest || y < shortest) {
        throw Error(
            Text::tr("Paper of %1 × %2 mm is too small to calibrate a printer; use A5 or larger")
                .arg(page.paper.width())
                .arg(page.paper.height()),
            QStringLiteral("paper"));
    }
    return {Millimetres(x), Millimetres(y)};
}

void paintCalibrationPage(QPainter& painter, const CalibrationPage& page) {
    const CalibrationLengths lengths = calibrationLengths(page);
    const double left = page.clearance.value();
    const double bottom = page.paper.height() - page.clearance.value();
    const SheetStrip across{{left + rulerDepth, bottom - rulerDepth},
                            0,
                            {lengths.x.value() + 2 * rulerEndRoom, rulerDepth},
                            false};
    // This ruler reads upwards; its scale is on the side of the page's edge.
    const SheetStrip along{{left, bottom - rulerDepth},
                           -90,
                           {lengths.y.value() + 2 * rulerEndRoom, rulerDepth},
                           false};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintWords(painter, page);
    paintRuler(painter, across);
    paintRuler(painter, along);
    const QRectF room(left + rulerDepth + 5, left + headHeight + 5,
                      page.paper.width() - 2 * left - rulerDepth - 10,
                      bottom - rulerDepth - 5 - (left + headHeight + 5));
    paintChessboard(painter, room);
    painter.restore();
}

void writeCalibrationPdf(const CalibrationPage& page, QIODevice& device) {
    PdfSettings settings;
    settings.title = Text::tr("Calibration of the printer's scale");
    const auto paint = [&](QPainter& painter) {
        correctScale(painter, page.paper, {page.scaleX, page.scaleY});
        paintCalibrationPage(painter, page);
    };
    const QByteArray pdf = pdfDocument({{page.paper, paint}}, settings);
    writeTo(device, pdf, Text::tr("The calibration page cannot be written: %1"),
            QStringLiteral("PDF"));
}

double calibratedScale(double printed, Millimetres length, Millimetres measured) {
    constexpr double most = 0.1;
    const double scale = printed * (measured / length);
    if (!(std::abs(scale - 1) <= most)) {
        throw Error(
            Text::tr(
                "A ruler of %2 mm measures %1 mm, which differs by more than 10 %; switch off all "
                "scaling in the printer's settings, print the page again and measure again")
                .arg(plain(measured.value()), plain(length.value())),
            QStringLiteral("calibration"));
    }
    return scale;
}

} // namespace dipwright
