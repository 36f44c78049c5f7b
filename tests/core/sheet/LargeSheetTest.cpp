// Measures the memory for the sheet of a large film with a small picture. This is a separate
// program, because peak memory is measured for the whole process.
#include "base/ImageRows.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/prepress/SheetFiles.h"

#include <QBuffer>
#include <QImageReader>
#include <QtTest>

#include <sys/resource.h>

using namespace dipwright;

namespace {

double peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

// Returns a sheet of 700 × 1000 mm at 300 dpi, 98 million pixels, with a patch of 60 × 60 mm.
Sheet largeSheet() {
    Sheet sheet;
    sheet.filmWidth = Millimetres(700);
    sheet.filmHeight = Millimetres(1000);
    const QSize pixels = sheetPixels(sheet.filmWidth, sheet.filmHeight, DotsPerInch(300));
    sheet.settings.resolution = DotsPerInch(300);
    sheet.image = blankImage(pixels, QImage::Format_RGBA8888);
    QPainter painter(&sheet.image);
    painter.fillRect(4000, 5000, 709, 709, QColor(20, 90, 160));
    return sheet;
}

class LargeSheetTest : public QObject {
    Q_OBJECT

private slots:
    // One copy of the picture alone would be 390 MB.
    void preparedSheet_mostlyBlankFilm_filesTakeLittleMemory() {
        const double before = peakMegabytes();
        const Sheet sheet = largeSheet();
        QCOMPARE(inkedBox(sheet), QRect(4000, 5000, 709, 709));
        const PreparedSheet prepared = preparedSheet(sheet, {});
        QVERIFY(sheetPdf(prepared, {}).startsWith("%PDF"));
        QBuffer png;
        png.setData(sheetPng(prepared));
        png.open(QIODevice::ReadOnly);
        QCOMPARE(QImageReader(&png, "png").size(), sheet.image.size());
        const double risen = peakMegabytes() - before;
        QVERIFY2(risen < 200, qPrintable(QStringLiteral("%1 MB").arg(risen)));
    }
};

} // namespace

QTEST_MAIN(LargeSheetTest)
#include "LargeSheetTest.moc"
