// Tests the separation proof: its plates are those of the print files, as Ghostscript separates
// them, and its figures are those of the plates.
#include "PaperMeasure.h"
#include "TestProfiles.h"

#include "sheet/prepress/PlateProof.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>

using namespace dipwright;

namespace {

constexpr int dpi = 127; // five pixels per mm

// A film of 40 × 20 mm with eight columns of colours, white ink under the left half, and a red
// spot ink on the lower half. In a PDF, # begins an escape, and #43 is C.
Sheet colourSheet() {
    Sheet sheet;
    sheet.filmWidth = Millimetres(40);
    sheet.filmHeight = Millimetres(20);
    sheet.settings.resolution = DotsPerInch(dpi);
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    sheet.image = QImage(200, 100, QImage::Format_RGBA8888);
    QImage white(200, 100, QImage::Format_Grayscale8), red(white.size(), white.format());
    const QList<QColor> colours{Qt::white, Qt::cyan,           Qt::magenta,     Qt::yellow,
                                Qt::black, QColor(90, 60, 40), {200, 180, 160}, {20, 80, 160}};
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 200; ++x) {
            sheet.image.setPixelColor(x, y, colours[x / 25]);
            white.scanLine(y)[x] = x < 100 ? 204 : 0;
            red.scanLine(y)[x] = y < 50 ? 0 : 102;
        }
    }
    sheet.plates = {{QStringLiteral("Red#43"), red, false, QColor(Qt::red)},
                    {QStringLiteral("White"), white, false, {}}};
    return sheet;
}

} // namespace

class PlateProofTest : public QObject {
    Q_OBJECT

    const PrinterColour colour_{simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                                false, "inks"};
    const PrintCorrection correction_{.colour = &colour_, .totalInk = 2.2};

private slots:
    void proof_allPlates_equalGhostscriptsSeparation() {
        const Sheet sheet = colourSheet();
        const QTemporaryDir folder;
        QFile file(folder.filePath("sheet.pdf"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        writeSheetPdf(sheet, file, correction_);
        file.close();
        output("gs", {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep",
                      QString("-r%1").arg(dpi), "-o", folder.filePath("page.tif"),
                      folder.filePath("sheet.pdf")});
        const Plates plates = separate(sheet, correction_);
        for (const ProofPlate& plate : proofPlates(plates, colour_)) {
            const QImage separated = QImage(folder.filePath(QString("page(%1).tif").arg(plate.ink)))
                                         .convertToFormat(QImage::Format_Grayscale8);
            QVERIFY2(!separated.isNull(), qPrintable(plate.ink));
            const QImage own = greyPlate(plates, plate.channel);
            for (int column = 0; column < 8; ++column) {
                for (const int y : {20, 80}) {
                    const QPoint at(25 * column + 12, y);
                    QVERIFY2(std::abs(qGray(separated.pixel(at)) - qGray(own.pixel(at))) <= 1,
                             qPrintable(plate.ink));
                }
            }
        }
    }

    void figures_knownSheet_areItsInk() {
        const Plates plates = separate(colourSheet(), correction_);
        const InkFigures figures = inkFigures(plates, colour_, {40, 20}, 1.9);
        QCOMPARE(figures.plates.size(), std::size_t(6));
        QCOMPARE(figures.plates[0].plate.ink, QStringLiteral("Cyan"));
        QCOMPARE(figures.plates[4].plate.ink, QStringLiteral("Red#43"));
        QVERIFY(std::abs(figures.plates[4].fullTintArea - 0.4 * 400) < 1);
        QCOMPARE(figures.plates[4].inkedArea, 400.0);
        QVERIFY(figures.plates[5].plate.isWhite);
        QVERIFY(std::abs(figures.plates[5].mostTint - 0.8) < 0.01);
        QVERIFY(std::abs(figures.inkedArea - 700) < 1); // all but the white column
        QVERIFY(figures.mostInk <= 2.2 && figures.mostInk > 2.18);
        // Black, dark brown and blue exceed 190 %.
        double expected = 0;
        for (int x = 0; x < 200; ++x) {
            expected += inkAt(plates, {x, 50}) > 1.9 ? 0.2 * 20 : 0;
        }
        QVERIFY(expected > 0);
        QVERIFY(std::abs(figures.areaAbove - expected) < 1e-6);
        QCOMPARE(inkFigures(plates, colour_, {40, 20}, 2.2).areaAbove, 0.0);
    }

    void composite_hiddenPlates_doNotPrint() {
        const Plates plates = separate(colourSheet(), correction_);
        const std::vector<bool> none(6, false);
        std::vector<bool> cyan = none;
        cyan[0] = true;
        const QImage paper = composite(plates, colour_, none);
        QVERIFY(qGray(paper.pixel(40, 20)) > 250);
        const QImage one = composite(plates, colour_, cyan);
        QVERIFY(qRed(one.pixel(40, 20)) < 60 && qBlue(one.pixel(40, 20)) > 240);
        QVERIFY(qGray(one.pixel(60, 20)) > 250); // magenta is hidden
        std::vector<bool> white = none;
        white[5] = true; // covers the ground to 80 %
        const QImage ground = composite(plates, colour_, white, QColor(Qt::black));
        QVERIFY(qGray(ground.pixel(10, 20)) > 220);
        QVERIFY(qGray(ground.pixel(150, 20)) < 5);
    }

    void totalInkMap_aboveTheLimit_isRed() {
        const Plates plates = separate(colourSheet(), correction_);
        const QImage map = totalInkMap(plates, 1.9);
        QCOMPARE(map.pixelColor(10, 20), QColor(Qt::white));
        QCOMPARE(map.pixelColor(110, 20), totalInkColour(2.2, 1.9)); // black
        QVERIFY(map.pixelColor(110, 20).red() > 200 && map.pixelColor(110, 20).blue() < 100);
        QVERIFY(map.pixelColor(40, 20).blue() > map.pixelColor(40, 20).red());
    }

    void reducedPlates_meanOfThePixels() {
        const Plates plates = separate(colourSheet(), correction_);
        const Plates small = reducedPlates(plates, 5);
        QCOMPARE(small.size, QSize(40, 20));
        QCOMPARE(tintAt(small, 5, {3, 15}), 204);
        QCOMPARE(tintAt(small, 4, {3, 15}), 102);
        QCOMPARE(tintAt(small, 0, {7, 3}), tintAt(plates, 0, {35, 15}));
    }

    void separationProof_filesOfAllPlates_haveTheFilmsResolution() {
        const SeparationProof proof = separationProof(colourSheet(), correction_);
        QStringList names;
        for (const ProofFile& file : proof.files) {
            names << file.name;
        }
        QCOMPARE(names,
                 QStringList({"plate-1-Cyan.png", "plate-2-Magenta.png", "plate-3-Yellow.png",
                              "plate-4-Black.png", "plate-5-Red-43.png", "plate-6-White.png",
                              "total-ink.png", "composite.png", "plates.json"}));
        const QImage white = QImage::fromData(proof.files[5].contents);
        QCOMPARE(white.size(), QSize(200, 100));
        QCOMPARE(white.dotsPerMeterX(), 5000);
        QCOMPARE(qGray(white.pixel(10, 10)), 51);
        const QJsonDocument json = QJsonDocument::fromJson(proof.files[8].contents);
        QCOMPARE(json["plates"][5]["ink"].toString(), QStringLiteral("White"));
        QCOMPARE(json["limit"].toDouble(), 2.2);
        QVERIFY(figuresTable(proof.figures).contains("above the limit of 220.0 %: 0.0 mm²"));
        QVERIFY(!figuresTable(proof.figures).contains("pass"));
        QVERIFY(figuresTable(proof.figures, 2).contains("figures of one pass of 2"));
    }
};

QTEST_MAIN(PlateProofTest)
#include "PlateProofTest.moc"
