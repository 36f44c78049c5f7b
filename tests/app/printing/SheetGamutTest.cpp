// Tests which colours of a sheet count as out of the printer's gamut.
#include "TestProfiles.h"
#include "printing/PrintFile.h"
#include "texture/StretchPlane.h"

#include <QtTest>

using namespace dipwright;

namespace {

constexpr int side = 16; // pixels

// A black sheet. Its upper half has amounts of ink in the space `space`.
Sheet blackSheet(const QString& space) {
    Sheet sheet;
    sheet.filmWidth = sheet.filmHeight = Millimetres(side);
    sheet.image = QImage(side, side, QImage::Format_RGBA8888);
    sheet.image.fill(Qt::black);
    QImage inks = inkPicture({side, side}, space);
    inks.fill(QColor(200, 200, 200, 100));
    InkPlanes planes = inkPlanes(inks);
    for (int y = side / 2; y < side; ++y) {
        std::fill_n(planes.black.scanLine(y), 4 * side, uchar(0));
    }
    sheet.wanted = WantedInk{sheet.image, unstretched({side, side}), {}, planes};
    return sheet;
}

} // namespace

class SheetGamutTest : public QObject {
    Q_OBJECT

private slots:
    void sheetGamut_keptAmounts_areNotOutOfGamut() {
        PrinterProfile printer;
        printer.iccProfile = simpleCmykProfile(0.3); // does not print black
        const PrinterColour colour(printer, {});
        const auto gamut = [&](const QString& space) {
            const Sheet sheet = blackSheet(space);
            return sheetGamut(sheet, colour, requestedColours(sheet, colour));
        };
        const GamutWarning own = gamut(iccIdentity(printer.iccProfile));
        QCOMPARE(own.share, 0.5);
        QCOMPARE(own.mask.constScanLine(0)[0], uchar(0));
        QCOMPARE(own.mask.constScanLine(side - 1)[0], uchar(255));
        // Amounts in another space are separated again.
        QCOMPARE(gamut(QString(32, u'0')).share, 1.0);
    }
};

QTEST_MAIN(SheetGamutTest)
#include "SheetGamutTest.moc"
