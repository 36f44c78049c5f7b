// Tests the corrected scale and calibration pages for printers that stretch, and tiles for small
// paper.
#include "PaperMeasure.h"

#include "sheet/page/CalibrationPage.h"
#include "sheet/prepress/SheetFiles.h"
#include "sheet/prepress/TiledSheet.h"

#include "base/Error.h"
#include "sheet/page/SheetLayout.h"

#include <QBuffer>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

using namespace dipwright;

namespace {

constexpr int dpi = 1200;
constexpr double pixelsPerMm = dpi / millimetresPerInch;

Sheet patchSheet(Millimetres width = Millimetres(210), Millimetres height = Millimetres(297)) {
    Sheet sheet;
    sheet.filmWidth = width;
    sheet.filmHeight = height;
    sheet.settings.resolution = DotsPerInch(100);
    sheet.image =
        QImage(sheetPixels(width, height, sheet.settings.resolution), QImage::Format_RGBA8888);
    sheet.image.fill(Qt::transparent);
    QPainter painter(&sheet.image);
    painter.fillRect(sheet.image.rect().adjusted(150, 150, -150, -150), QColor(20, 90, 160));
    sheet.job.immersion = QStringLiteral("Top");
    sheet.job.hash = QStringLiteral("c0ffee");
    return sheet;
}

std::vector<double> ticks(const QImage& grey, bool alongRow, int at) {
    std::vector<double> found = darkMiddles(grey, alongRow, at);
    for (double& tick : found) {
        tick /= pixelsPerMm;
    }
    return found;
}

} // namespace

class SheetScaleTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    template <typename Write>
    QString saved(const QString& name, Write write) {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        write(file);
        return file.fileName();
    }

    static QImage rendered(const QString& path, const QRectF& box, int page = 1) {
        return renderedPage(path, dpi, box, page);
    }

private slots:
    void writeSheetPdf_printerScale_rulerMeasures100mm();
    void verificationPage_printerScale_measuresItsLength();
    void calibrationPage_measuresTheStatedLengths();
    void calibrationPage_everyPaper_fits();
    void calibratedScale_measuredLengths_giveTheScale();
    void sheetLayout_clearance_keepsMarksOffTheMargins();
    void sheetTiles_coverTheWholeSheet();
    void sheetTiles_blankTiles_areLeftOut();
    void writeTiledPdf_hasOnePageForEachTile();
    void writeTiledPdf_everyTile_hasJobNumberAndWholeRuler();
    void writeTiledPdf_labels_areOnBarePaper();
    void sheetTiles_tooSmallPaper_isRefused();
};

// The printer stretches by 1.004 × 0.997, and the file is corrected for this stretch. The test
// multiplies the length measured in the file by the printer's stretch.
void SheetScaleTest::writeSheetPdf_printerScale_rulerMeasures100mm() {
    constexpr double stretchX = 1.004;
    const Sheet sheet = patchSheet();
    const QString path = saved("corrected.pdf", [&](QIODevice& device) {
        PrintCorrection correction;
        correction.scaleX = stretchX;
        correction.scaleY = 0.997;
        writeSheetPdf(sheet, device, correction);
    });
    const QRectF ruler = sheetLayout(sheet).ruler->box();
    const QImage strip = rendered(path, ruler.adjusted(-1, -1, 1, 1));
    // Scaling the page about its middle moves the ruler's lower edge outwards by 0.003 · 145 mm.
    std::vector<double> found;
    for (int row = strip.height() - 1; row > 0 && found.size() != 101; --row) {
        found = ticks(strip, true, row);
    }
    QCOMPARE(found.size(), std::size_t(101));
    const double onWhitePaper = (found.back() - found.front()) * stretchX;
    QVERIFY2(
        std::abs(onWhitePaper - 100) < 0.05,
        qPrintable(QStringLiteral("the ruler measures %1 mm, expected 100 mm").arg(onWhitePaper)));
}

void SheetScaleTest::verificationPage_printerScale_measuresItsLength() {
    constexpr double stretchY = 0.997;
    CalibrationPage page;
    page.scaleX = 1.004;
    page.scaleY = stretchY;
    QVERIFY(page.verifies());
    const QString path =
        saved("verify.pdf", [&](QIODevice& device) { writeCalibrationPdf(page, device); });
    const QImage strip = rendered(path, QRectF(9, 46, 7, 250));
    std::vector<double> found;
    const auto expected = std::size_t(std::lround(calibrationLengths(page).y.value())) + 1;
    for (int column = strip.width() - 1; column > 0 && found.size() != expected; --column) {
        found = ticks(strip, false, column);
    }
    QCOMPARE(found.size(), expected);
    const double onWhitePaper = (found.back() - found.front()) * stretchY;
    QVERIFY2(std::abs(onWhitePaper - calibrationLengths(page).y.value()) < 0.05,
             qPrintable(QStringLiteral("the scale measures %1 mm, expected %2 mm")
                            .arg(onWhitePaper)
                            .arg(calibrationLengths(page).y.value())));
}

void SheetScaleTest::calibrationPage_measuresTheStatedLengths() {
    CalibrationPage page;
    page.printer = QStringLiteral("Canon imagePROGRAF");
    const QString path =
        saved("calibrate.pdf", [&](QIODevice& device) { writeCalibrationPdf(page, device); });
    const QString words = pdfWords(path);
    const CalibrationLengths lengths = calibrationLengths(page);
    QVERIFY(words.contains("Canon imagePROGRAF"));
    QVERIFY(words.contains(QString::number(lengths.x.value())));
    QVERIFY(words.contains(QString::number(lengths.y.value())));
    const QRectF lowest(10, 297 - 10 - 0.7, 190, 0.5);
    const std::vector<double> found = ticks(rendered(path, lowest), true, 5);
    QCOMPARE(found.size(), std::size_t(lengths.x.value()) + 1);
    QVERIFY(std::abs(found.back() - found.front() - lengths.x.value()) < 0.01);
    QBuffer again;
    again.open(QIODevice::WriteOnly);
    writeCalibrationPdf(page, again);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(again.data(), file.readAll());
}

void SheetScaleTest::calibrationPage_everyPaper_fits() {
    for (const QSizeF& paper :
         {QSizeF(148, 210), QSizeF(297, 210), QSizeF(297, 420), QSizeF(610, 900)}) {
        CalibrationPage page;
        page.paper = paper;
        const CalibrationLengths lengths = calibrationLengths(page);
        QVERIFY(lengths.x.value() > paper.width() * 0.6 && lengths.x.value() < paper.width() - 20);
        QVERIFY(lengths.y.value() > paper.height() * 0.5 &&
                lengths.y.value() < paper.height() - 50);
    }
    CalibrationPage tiny;
    tiny.paper = {80, 100};
    QVERIFY_EXCEPTION_THROWN(calibrationLengths(tiny), Error);
}

void SheetScaleTest::calibratedScale_measuredLengths_giveTheScale() {
    QCOMPARE(calibratedScale(1, Millimetres(180), Millimetres(180.72)), 1.004);
    // The error measured on a corrected page is multiplied with the page's scale.
    QCOMPARE(calibratedScale(1.004, Millimetres(180), Millimetres(180)), 1.004);
    QVERIFY(std::abs(calibratedScale(1.004, Millimetres(200), Millimetres(199)) - 1.004 * 0.995) <
            1e-12);
    QVERIFY_EXCEPTION_THROWN(calibratedScale(1, Millimetres(180), Millimetres(161)), Error);
    QVERIFY_EXCEPTION_THROWN(calibratedScale(1, Millimetres(180), Millimetres(0)), Error);
    QVERIFY_EXCEPTION_THROWN(calibratedScale(1, Millimetres(180), Millimetres(qQNaN())), Error);
}

void SheetScaleTest::sheetLayout_clearance_keepsMarksOffTheMargins() {
    Sheet sheet = patchSheet();
    sheet.clearance = Millimetres(6.5);
    const SheetLayout layout = sheetLayout(sheet);
    const QRectF reach = QRectF({0, 0}, layout.page).adjusted(6.49, 6.49, -6.49, -6.49);
    for (const SheetMark& mark : layout.marks) {
        QVERIFY(reach.contains(mark.box()));
    }
    QVERIFY(reach.contains(layout.ruler->box()));
    QVERIFY(reach.contains(layout.jobLine->box()));
}

void SheetScaleTest::sheetTiles_coverTheWholeSheet() {
    const Sheet sheet = patchSheet(Millimetres(400), Millimetres(500));
    const TileSettings settings;
    const std::vector<SheetTile> tiles = sheetTiles(sheet, settings);
    QCOMPARE(tiles.size(),
             std::size_t(3 * 2)); // 400 mm in tiles of 200 mm with an overlap of 10 mm
    for (double x = 0.5; x < 400; x += 7) {
        for (double y = 0.5; y < 500; y += 7) {
            QVERIFY(std::any_of(tiles.begin(), tiles.end(),
                                [&](const SheetTile& tile) { return tile.box.contains(x, y); }));
        }
    }
}

// The patch ends 38.1 mm before the edges, so the last column of tiles is blank but for the marks.
void SheetScaleTest::sheetTiles_blankTiles_areLeftOut() {
    Sheet sheet = patchSheet(Millimetres(400), Millimetres(250));
    QCOMPARE(sheetTiles(sheet, {}).size(), std::size_t(3)); // the third tile has two marks
    sheet.settings.marks = false;
    const std::vector<SheetTile> tiles = sheetTiles(sheet, {});
    QCOMPARE(tiles.size(), std::size_t(2));
    QCOMPARE(tiles.back().column, 1);
    sheet.plates = {
        {QStringLiteral("White"), QImage(sheet.image.size(), QImage::Format_Grayscale8)}};
    sheet.plates[0].tint.fill(0);
    QCOMPARE(sheetTiles(sheet, {}).size(), std::size_t(2));
    sheet.plates[0].tint.setPixelColor(sheet.image.width() - 5, 400, Qt::white);
    QCOMPARE(sheetTiles(sheet, {}).size(), std::size_t(3));
}

void SheetScaleTest::writeTiledPdf_everyTile_hasJobNumberAndWholeRuler() {
    Sheet sheet = patchSheet(Millimetres(300), Millimetres(270));
    sheet.job.project = QStringLiteral("Turtle");
    const TileSettings settings;
    const QString path =
        saved("ruled.pdf", [&](QIODevice& device) { writeTiledPdf(sheet, settings, device); });
    const double foot = settings.paper.height() - settings.margins.bottom();
    for (int page : {1, 2}) {
        const QString words = pdfWords(path, page);
        QVERIFY2(words.contains("c0ffee") && words.contains("Turtle") && words.contains("Top"),
                 qPrintable(words));
        const QImage strip = rendered(path, QRectF(5, foot - 9, 200, 5), page);
        std::vector<double> found;
        for (int row = strip.height() - 1; row > 0 && found.size() != 101; --row) {
            found = ticks(strip, true, row);
        }
        QCOMPARE(found.size(), std::size_t(101));
        const double length = found.back() - found.front();
        QVERIFY2(std::abs(length - 100) < 0.05, qPrintable(QString::number(length)));
    }
}

void SheetScaleTest::writeTiledPdf_hasOnePageForEachTile() {
    const Sheet sheet = patchSheet(Millimetres(300), Millimetres(270));
    const QString path = saved(
        "tiles.pdf", [&](QIODevice& device) { writeTiledPdf(sheet, TileSettings{}, device); });
    const QByteArray info = output("pdfinfo", {path});
    QVERIFY(info.contains("Pages:           2"));
    QVERIFY(info.contains("A4"));
    QVERIFY(pdfWords(path, 2).contains("column 2 of 2"));
    // The patch reaches from 38.1 mm to 261.9 mm on the sheet. The second tile starts at 190 mm.
    const std::vector<double> patch = ticks(rendered(path, QRectF(0, 100, 210, 1), 2), true, 10);
    QCOMPARE(patch.size(), std::size_t(1));
    QVERIFY2(std::abs(patch[0] - (5 + 71.9 / 2)) < 0.3,
             qPrintable(QStringLiteral("the patch's middle is at %1 mm, expected %2 mm")
                            .arg(patch[0])
                            .arg(5 + 71.9 / 2)));
}

// On paint a label is hard to read, and its rim removes paint from the film.
void SheetScaleTest::writeTiledPdf_labels_areOnBarePaper() {
    Sheet sheet = patchSheet(Millimetres(300), Millimetres(500));
    sheet.image.fill(QColor(20, 90, 160));
    const TileSettings settings;
    const QString path =
        saved("labels.pdf", [&](QIODevice& device) { writeTiledPdf(sheet, settings, device); });
    QVERIFY(pdfWords(path).contains("Row 1 of 2, column 1 of 2"));
    const double foot = settings.paper.height() - settings.margins.bottom();
    const QImage strip = rendered(path, QRectF(11, foot - 3.8, 100, 3.6));
    int bare = 0;
    int dark = 0;
    for (int y = 0; y < strip.height(); ++y) {
        for (int x = 0; x < strip.width(); ++x) {
            bare += qGray(strip.pixel(x, y)) > 250;
            dark += qGray(strip.pixel(x, y)) < 60;
        }
    }
    QVERIFY(bare > strip.width() * strip.height() / 2);
    QVERIFY(dark > 100);
}

void SheetScaleTest::sheetTiles_tooSmallPaper_isRefused() {
    TileSettings settings;
    settings.paper = {18, 297};
    QVERIFY_EXCEPTION_THROWN(sheetTiles(patchSheet(), settings), Error);
    settings.paper = {25, 25};
    QVERIFY_EXCEPTION_THROWN(sheetTiles(patchSheet(Millimetres(400), Millimetres(500)), settings),
                             Error);
}

QTEST_MAIN(SheetScaleTest)
#include "SheetScaleTest.moc"
