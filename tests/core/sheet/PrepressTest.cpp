// Tests files for print shops, PDF/X in CMYK, with independent programs.
#include "ChessSheet.h"
#include "PaperMeasure.h"
#include "TestProfiles.h"

#include "base/WideGamut.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"
#include "sheet/prepress/TiledSheet.h"
#include "texture/StretchPlane.h"

#include <QScopeGuard>
#include <QtTest>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <lcms2.h>
#include <map>
#include <tiffio.h>

using namespace dipwright;

namespace {

constexpr double dark = 0.8; // pixels above this share of full ink count as dark

// Returns a plate with a half tint of white over 20 × 20 mm in the film's upper left.
QImage cornerOfWhite(const Sheet& sheet) {
    QImage white(sheet.image.size(), QImage::Format_Grayscale8);
    white.fill(0);
    for (int y = 0; y < white.height() / 4; ++y) {
        for (int x = 0; x < white.width() / 5; ++x) {
            white.scanLine(y)[x] = 128;
        }
    }
    return white;
}

// A page's plates by name, in grey: 0 is full ink, 255 is none.
using Separations = std::map<QString, QImage>;

Separations separations(const QString& pdf, int dpi) {
    const QTemporaryDir folder;
    output("gs", {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep",
                  QString("-r%1").arg(dpi), "-o", folder.filePath("page.tif"), pdf});
    Separations plates;
    for (const QFileInfo& file : QDir(folder.path()).entryInfoList({"page(*).tif"})) {
        plates[file.fileName().mid(5).chopped(5)] =
            QImage(file.filePath()).convertToFormat(QImage::Format_Grayscale8);
    }
    return plates;
}

double ink(const Separations& plates, const QString& name, QPoint at) {
    return 1 - qGray(plates.at(name).pixel(at)) / 255.0;
}

int inkedPixels(const QImage& plate) {
    int count = 0;
    for (int y = 0; y < plate.height(); ++y) {
        for (int x = 0; x < plate.width(); ++x) {
            count += qGray(plate.pixel(x, y)) < 255 * (1 - dark);
        }
    }
    return count;
}

// Compares the mean width of a black square and of the white square beside it. Partly inked pixels
// at the edges, darker in CMYK than in RGB, make the black square wider and the white square
// narrower.
void verifyPitch(const QString& path, bool across, double wanted) {
    const std::vector<double> sizes = squares(path, across);
    QVERIFY(sizes.size() >= 8);
    for (std::size_t i = 1; i < sizes.size(); ++i) {
        const double pitch = (sizes[i - 1] + sizes[i]) / 2;
        QVERIFY2(
            std::abs(pitch - wanted) <= 0.02,
            qPrintable(
                QStringLiteral("a square measures %1 mm, expected %2 mm").arg(pitch).arg(wanted)));
    }
}

// Colours of patches of 10 mm.
const QList<QColor> patches{QColor(128, 128, 128), QColor(200, 60, 60),  QColor(40, 120, 60),
                            QColor(30, 40, 160),   QColor(240, 220, 40), QColor(10, 10, 10)};

Sheet patchSheet() {
    Sheet sheet;
    sheet.filmWidth = Millimetres(100);
    sheet.filmHeight = Millimetres(80);
    sheet.settings.resolution = DotsPerInch(150);
    sheet.image = QImage(sheetPixels(sheet.filmWidth, sheet.filmHeight, DotsPerInch(150)),
                         QImage::Format_RGBA8888);
    sheet.image.fill(Qt::transparent);
    QPainter painter(&sheet.image);
    painter.scale(sheet.image.width() / 100.0, sheet.image.height() / 80.0);
    for (int i = 0; i < int(patches.size()); ++i) {
        painter.fillRect(QRectF(20 + 10 * i, 35, 10, 10), patches[i]);
    }
    sheet.job = {"Turtle", "Top", "2026-03-01", "A4", "1:1", "3fa9c2d1"};
    return sheet;
}

} // namespace

class PrepressTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    const PrinterColour inks_{simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                              false, "inks.icc"};

    QString written(const QString& name, const std::function<void(QIODevice&)>& write) const {
        QFile file(folder_.filePath(name));
        if (file.open(QIODevice::WriteOnly)) {
            write(file);
        }
        return file.fileName();
    }
    QString pdfOf(const Sheet& sheet, const PrintCorrection& correction) const {
        return written("sheet.pdf",
                       [&](QIODevice& device) { writeSheetPdf(sheet, device, correction); });
    }

private slots:
    void writeSheetPdf_cmyk_isPdfX4();
    void writeSheetPdf_cmykSquares_measure17mm();
    void writeSheetPdf_cmykScaleAndTurn_areCorrected();
    void writeTiledPdf_cmyk_isValid();
    void writeSheetPdf_cmykColours_matchTheProfile();
    void writeSheetPdf_cmykText_isBlackInkOnly();
    void writeSheetPdf_registrationMarks_areOnEveryPlate();
    void writeSheetPdf_totalInk_isLimited();
    void cutLine_isASeparatePlate();
    void cutLine_keepsItsDistanceFromTheInk();
    void cutLine_goesRoundAllPlates_data();
    void cutLine_goesRoundAllPlates();
    void cutBleed_continuesColourPastTheCut();
    void cutBleed_spotInkAndMask_stayAsTheyAre();
    void white_isASeparatePlate_data();
    void white_isASeparatePlate();
    void pdfTarget_keepsAllPlates_data();
    void pdfTarget_keepsAllPlates();
    void squarePixels_tiff_hasOneResolution_data();
    void squarePixels_tiff_hasOneResolution();
    void spotPlates_keepNamesAndOrder();
    void writeSheetTiff_white_isANamedSample();
    void choked_white_isSmallerOnAllSides();
    void choked_whiteThatFadesAtSeam_keepsItsFade();
    void writeSheetPdf_cmykTwice_givesTheSameBytes();
};

void PrepressTest::writeSheetPdf_cmyk_isPdfX4() {
    const QString path = pdfOf(patchSheet(), {.colour = &inks_});
    const QByteArray info = output("pdfinfo", {"-box", path});
    QVERIFY2(info.contains("PDF/X-4") && info.contains("Turtle – Top"), info);
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    const QByteArray document = output("qpdf", {"--qdf", "--stream-data=uncompress", path, "-"});
    for (const char* words : {"/GTS_PDFX", "/N 4", "/TrimBox", "/PrintScaling /None",
                              "/ColorSpace /DeviceCMYK", "/Trapped /False"}) {
        QVERIFY2(document.contains(words), words);
    }
    QVERIFY(document.contains(inks_.iccProfile()));
    QVERIFY(!document.contains("/DeviceRGB"));
    QVERIFY(std::abs(pdfPage(path).width() - 100) < 0.005);
    QVERIFY(std::abs(pdfPage(path).height() - 80) < 0.005);
}

void PrepressTest::writeSheetPdf_cmykSquares_measure17mm() {
    const QString path = pdfOf(chessSheet("Top"), {.colour = &inks_});
    verifyPitch(path, true, 17);
    verifyPitch(path, false, 17);
}

void PrepressTest::writeSheetPdf_cmykScaleAndTurn_areCorrected() {
    const QString path =
        pdfOf(chessSheet("Top", {297, 210}),
              {.scaleX = 1.004, .scaleY = 0.997, .colour = &inks_, .acrossPaper = true});
    QVERIFY(std::abs(pdfPage(path).width() - 210) < 0.02);
    verifyPitch(path, true, 17 / 1.004);
    verifyPitch(path, false, 17 / 0.997);
}

void PrepressTest::writeTiledPdf_cmyk_isValid() {
    const QString path = written("tiles.pdf", [&](QIODevice& device) {
        writeTiledPdf(chessSheet("Top"), {.paper = {148, 210}}, device, {.colour = &inks_});
    });
    QVERIFY(output("pdfinfo", {path}).contains("Pages:           4"));
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    for (int page = 1; page <= 4; ++page) {
        const QImage edge = renderedPage(path, 100, QRectF(0, 0, 148, 1.7), page);
        for (int y = 0; y < edge.height(); ++y) {
            QVERIFY(darkMiddles(edge, true, y).empty());
        }
    }
}

// The plates give the colours that lcms2 computes from the profile.
void PrepressTest::writeSheetPdf_cmykColours_matchTheProfile() {
    for (const bool wide : {false, true}) {
        Sheet sheet = patchSheet();
        if (wide) {
            sheet.image = inWide(sheet.image);
        }
        const Separations plates = separations(pdfOf(sheet, {.colour = &inks_}), 150);
        QCOMPARE(plates.size(), std::size_t(4));
        const QByteArray icc = inks_.iccProfile();
        const cmsHPROFILE printer =
            cmsOpenProfileFromMem(icc.constData(), cmsUInt32Number(icc.size()));
        const cmsHPROFILE screen = cmsCreate_sRGBProfile();
        const cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
        const cmsUInt32Number relative = INTENT_RELATIVE_COLORIMETRIC;
        const cmsHTRANSFORM own =
            cmsCreateTransform(screen, TYPE_RGB_8, printer, TYPE_CMYK_DBL, relative, 0);
        const cmsHTRANSFORM look =
            cmsCreateTransform(printer, TYPE_CMYK_DBL, lab, TYPE_Lab_DBL, relative, 0);
        for (int i = 0; i < int(patches.size()); ++i) {
            const QPoint at(int((25 + 10 * i) / 25.4 * 150), int(40 / 25.4 * 150));
            const double sent[4] = {100 * ink(plates, "Cyan", at), 100 * ink(plates, "Magenta", at),
                                    100 * ink(plates, "Yellow", at),
                                    100 * ink(plates, "Black", at)};
            const uchar rgb[3] = {uchar(patches[i].red()), uchar(patches[i].green()),
                                  uchar(patches[i].blue())};
            double wanted[4];
            cmsDoTransform(own, rgb, wanted, 1);
            cmsCIELab sentLab;
            cmsCIELab wantedLab;
            cmsDoTransform(look, sent, &sentLab, 1);
            cmsDoTransform(look, wanted, &wantedLab, 1);
            const double off = cmsDeltaE(&sentLab, &wantedLab);
            QVERIFY2(off <= 1,
                     qPrintable(
                         QString("%1: ΔE %2, expected 1 or less").arg(patches[i].name()).arg(off)));
        }
        for (const cmsHTRANSFORM transform : {own, look}) {
            cmsDeleteTransform(transform);
        }
        for (const cmsHPROFILE profile : {printer, screen, lab}) {
            cmsCloseProfile(profile);
        }
    }
}

void PrepressTest::writeSheetPdf_cmykText_isBlackInkOnly() {
    Sheet bare = patchSheet();
    bare.image.fill(Qt::transparent);
    bare.settings.marks = false;
    const Separations plates = separations(pdfOf(bare, {.colour = &inks_}), 300);
    QVERIFY(inkedPixels(plates.at("Black")) > 300);
    for (const char* colour : {"Cyan", "Magenta", "Yellow"}) {
        const QImage& plate = plates.at(colour);
        for (int y = 0; y < plate.height(); ++y) {
            for (int x = 0; x < plate.width(); ++x) {
                QCOMPARE(qGray(plate.pixel(x, y)), 255);
            }
        }
    }
}

void PrepressTest::writeSheetPdf_registrationMarks_areOnEveryPlate() {
    Sheet bare = patchSheet();
    bare.image.fill(Qt::transparent);
    bare.settings.ruler = bare.settings.jobLine = false;
    const QString path = pdfOf(bare, {.colour = &inks_});
    QVERIFY(output("qpdf", {"--qdf", path, "-"}).contains("/Separation"));
    const Separations plates = separations(path, 300);
    QVERIFY(inkedPixels(plates.at("Black")) > 300);
    for (const char* colour : {"Cyan", "Magenta", "Yellow"}) {
        QCOMPARE(plates.at(colour), plates.at("Black"));
    }
    // On paint, the marks have a bare rim.
    Sheet covered = patchSheet();
    covered.image.fill(QColor(200, 60, 60));
    const Separations onPaint = separations(pdfOf(covered, {.colour = &inks_}), 300);
    const QPoint besides(int(6.3 / 25.4 * 300), int(4 / 25.4 * 300)); // the first mark's arm
    for (const char* colour : {"Cyan", "Magenta", "Yellow", "Black"}) {
        QCOMPARE(ink(onPaint, colour, besides), 0.0);
    }
}

// The simple profile has no black generation, so a dark colour uses three inks.
void PrepressTest::writeSheetPdf_totalInk_isLimited() {
    const Sheet sheet = patchSheet();
    PrintCorrection correction{.colour = &inks_};
    const Separations free = separations(pdfOf(sheet, correction), 150);
    correction.totalInk = 2.4;
    const Separations limited = separations(pdfOf(sheet, correction), 150);
    const QStringList names{"Cyan", "Magenta", "Yellow", "Black"};
    double most = 0;
    for (int i = 0; i < int(patches.size()); ++i) {
        const QPoint at(int((25 + 10 * i) / 25.4 * 150), int(40 / 25.4 * 150));
        double before = 0;
        double after = 0;
        for (const QString& name : names) {
            before += ink(free, name, at);
            after += ink(limited, name, at);
        }
        most = std::max(most, before);
        QVERIFY2(after < 2.4 + 1e-9,
                 qPrintable(QStringLiteral("total ink %1, expected 2.4 or less").arg(after)));
        if (before <= 2.4) {
            QCOMPARE(after, before); // ink within the limit does not change
        } else {
            QVERIFY(after > 2.35);
        }
    }
    QVERIFY2(most > 2.5,
             qPrintable(QStringLiteral("most ink without a limit %1, expected > 2.5").arg(most)));
    // Black and the hue do not change.
    QByteArray pixel("\xff\x80\x40\xc8", 4);
    limitInk(pixel, 2);
    QCOMPARE(uchar(pixel[3]), uchar(200));
    QVERIFY(std::abs(double(uchar(pixel[0])) / uchar(pixel[1]) - 255.0 / 128) < 0.03);
}

void PrepressTest::cutLine_isASeparatePlate() {
    Sheet sheet = patchSheet();
    const Separations without = separations(pdfOf(sheet, {.colour = &inks_}), 150);
    sheet.settings.cutLine = CutLine::Ink;
    sheet.settings.cutName = QStringLiteral("Thru cut/1");
    const QString path = pdfOf(sheet, {.colour = &inks_});
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    const Separations plates = separations(path, 150);
    QCOMPARE(plates.size(), std::size_t(5));
    const auto cut = std::find_if(plates.begin(), plates.end(), [](const auto& plate) {
        return plate.first.startsWith("Thru cut");
    });
    QVERIFY(cut != plates.end());
    // It overprints, on a page without transparency.
    const QByteArray document = output("qpdf", {"--qdf", path, "-"});
    QVERIFY(document.contains("/OP true") && document.contains("/OPM 1"));
    QVERIFY(!document.contains("/Transparency") && !document.contains("/Multiply >> /"));
    // The cut line does not change the other plates. The marks are on all of them.
    for (const auto& [name, plate] : without) {
        QCOMPARE(plates.at(name), plate);
    }
    sheet.settings.cutLine = CutLine::None;
    QCOMPARE(separations(pdfOf(sheet, {.colour = &inks_}), 150).size(), std::size_t(4));
}

// The line surrounds patches of 60 × 10 mm in the middle. Its sides are straight, at the set
// distance, and its corners are round.
void PrepressTest::cutLine_keepsItsDistanceFromTheInk() {
    constexpr int dpi = 600;
    const auto pixels = [](double mm) { return mm / millimetresPerInch * dpi; };
    Sheet sheet = patchSheet();
    sheet.settings.marks = false;
    sheet.settings.cutLine = CutLine::Ink;
    sheet.settings.cutDistance = Millimetres(4);
    const QImage line = separations(pdfOf(sheet, {.colour = &inks_}), dpi).at("CutContour");
    const auto verify = [&](bool alongRow, double at, double first, double second) {
        const std::vector<double> middles = darkMiddles(line, alongRow, int(pixels(at)));
        QCOMPARE(middles.size(), std::size_t(2));
        const double tolerance = pixels(0.2); // a pixel with any ink counts fully
        QVERIFY2(std::abs(middles[0] - pixels(first)) < tolerance,
                 qPrintable(QStringLiteral("the line is at %1 mm, expected %2 mm")
                                .arg(middles[0] / pixels(1))
                                .arg(first)));
        QVERIFY2(std::abs(middles[1] - pixels(second)) < tolerance,
                 qPrintable(QStringLiteral("the line is at %1 mm, expected %2 mm")
                                .arg(middles[1] / pixels(1))
                                .arg(second)));
    };
    verify(true, 40, 16, 84);
    verify(false, 50, 31, 49);
    const double corner = 4 * std::sqrt(0.5); // place on the arc at 45°
    verify(true, 35 - corner, 20 - corner, 80 + corner);

    sheet.settings.cutLine = CutLine::Film;
    sheet.settings.paper = QStringLiteral("A4");
    const QImage edge = separations(pdfOf(sheet, {.colour = &inks_}), dpi).at("CutContour");
    const std::vector<double> sides = darkMiddles(edge, true, edge.height() / 2);
    QCOMPARE(sides.size(), std::size_t(2));
    QVERIFY(std::abs(sides[1] - sides[0] - pixels(100)) < pixels(0.02));
}

void PrepressTest::cutLine_goesRoundAllPlates_data() {
    QTest::addColumn<int>("plate");
    QTest::newRow("white printed last") << 0;
    QTest::newRow("varnish printed first") << 1;
    QTest::newRow("ink compensated separately") << 2;
}

// The cut line is 4 mm outside a square of 10 mm in the upper left, where the picture is empty.
void PrepressTest::cutLine_goesRoundAllPlates() {
    QFETCH(int, plate);
    constexpr int dpi = 150;
    const auto pixels = [](double mm) { return mm / millimetresPerInch * dpi; };
    Sheet sheet = patchSheet();
    sheet.settings.marks = false;
    sheet.settings.cutLine = CutLine::Ink;
    sheet.settings.cutDistance = Millimetres(4);
    QImage tint(sheet.image.size(), QImage::Format_Grayscale8);
    tint.fill(0);
    for (int y = int(pixels(10)); y < int(pixels(20)); ++y) {
        std::fill_n(tint.scanLine(y) + int(pixels(10)), int(pixels(10)), 180);
    }
    if (plate == 2) {
        QImage wanted = sheet.image;
        QPainter(&wanted).fillRect(QRectF(pixels(10), pixels(10), pixels(10), pixels(10)),
                                   QColor(30, 40, 160));
        sheet.wanted = WantedInk{wanted, unstretched(wanted.size()), {}};
    } else {
        sheet.plates = {{QStringLiteral("Spot"), tint, plate == 1}};
    }
    const QImage line = separations(pdfOf(sheet, {.colour = &inks_}), dpi).at("CutContour");
    const std::vector<double> middles = darkMiddles(line, true, int(pixels(15)));
    QCOMPARE(middles.size(), std::size_t(2));
    QVERIFY2(
        std::abs(middles[0] - pixels(6)) < pixels(0.3),
        qPrintable(
            QStringLiteral("the line is at %1 mm, expected 6 mm").arg(middles[0] / pixels(1))));
    QVERIFY2(
        std::abs(middles[1] - pixels(24)) < pixels(0.3),
        qPrintable(
            QStringLiteral("the line is at %1 mm, expected 24 mm").arg(middles[1] / pixels(1))));
}

// The patches of 60 × 10 mm in the film's middle are cut 1 mm from their edge, with 3 mm of bleed.
void PrepressTest::cutBleed_continuesColourPastTheCut() {
    constexpr int dpi = 150;
    const auto pixel = [](double x, double y) {
        return QPoint(int(x / millimetresPerInch * dpi), int(y / millimetresPerInch * dpi));
    };
    Sheet sheet = patchSheet();
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    sheet.settings.cutLine = CutLine::Ink;
    sheet.settings.cutDistance = Millimetres(1);
    QImage white(sheet.image.size(), QImage::Format_Grayscale8);
    white.fill(0);
    for (int y = white.height() * 36 / 80; y < white.height() * 44 / 80; ++y) {
        std::fill_n(white.scanLine(y) + white.width() * 21 / 100, white.width() * 58 / 100, 180);
    }
    sheet.plates = {{QStringLiteral("White"), white}};
    sheet.settings.white = WhiteLayer::Last;
    sheet.settings.whiteChoke = Millimetres(1);
    const Separations without = separations(pdfOf(sheet, {.colour = &inks_}), dpi);
    sheet.settings.cutBleed = Millimetres(3);
    const QString path = pdfOf(sheet, {.colour = &inks_});
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    const Separations plates = separations(path, dpi);
    QCOMPARE(plates.at("CutContour"), without.at("CutContour"));
    const double edge = ink(plates, "Magenta", pixel(35, 36)); // the second patch, red
    QVERIFY(edge > 0.3);
    QCOMPARE(ink(without, "Magenta", pixel(35, 33)), 0.0);
    QCOMPARE(ink(plates, "Magenta", pixel(35, 33)), edge);   // 2 mm out: past the cut
    QCOMPARE(ink(plates, "Magenta", pixel(35, 31.3)), edge); // 3.7 mm
    QCOMPARE(ink(plates, "Magenta", pixel(35, 30.7)), 0.0);  // 4.3 mm
    QVERIFY(ink(plates, "White", pixel(35, 33)) > 0.6);      // white keeps its choke
    QCOMPARE(ink(plates, "White", pixel(35, 31.4)), 0.0);
    // The page's boxes contain cut and bleed, in points from below.
    const QByteArray page = output("qpdf", {"--qdf", "--stream-data=uncompress", path, "-"});
    const auto box = [&](const char* name) {
        const auto at = page.indexOf('[', page.indexOf(name)) + 1;
        QList<double> sides;
        for (const QByteArray& word :
             page.mid(at, page.indexOf(']', at) - at).simplified().split(' ')) {
            sides << word.toDouble() / 72 * millimetresPerInch;
        }
        return sides;
    };
    const QList<double> trim = box("/TrimBox"), bleed = box("/BleedBox");
    const QList<double> cut{19, 34, 81, 46};
    QCOMPARE(trim.size(), 4);
    QCOMPARE(bleed.size(), 4);
    for (int side = 0; side < 4; ++side) {
        QVERIFY2(std::abs(trim[side] - cut[side]) < 0.25,
                 qPrintable(QStringLiteral("side %1 of the trim box is at %2 mm, expected %3 mm")
                                .arg(side)
                                .arg(trim[side])
                                .arg(cut[side])));
        QVERIFY(std::abs(std::abs(bleed[side] - trim[side]) - 3) < 1e-3);
    }
}

// A spot ink that ends before the edge of the paint, and a mask in the paint. Both are nearer to
// the cut than the bleed is wide.
void PrepressTest::cutBleed_spotInkAndMask_stayAsTheyAre() {
    constexpr int dpi = 150;
    const auto pixels = [](double length) { return int(length / millimetresPerInch * dpi); };
    const auto box = [&](double x, double y, double size) {
        return QRect(pixels(x), pixels(y), pixels(size), pixels(size));
    };
    Sheet sheet = patchSheet();
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    sheet.settings.cutLine = CutLine::Ink;
    sheet.settings.cutDistance = Millimetres(2);
    QPainter painter(&sheet.image);
    painter.setCompositionMode(QPainter::CompositionMode_Clear);
    painter.fillRect(box(43, 38, 4), Qt::transparent);
    painter.end();
    QImage gold(sheet.image.size(), QImage::Format_Grayscale8);
    gold.fill(0);
    QPainter(&gold).fillRect(box(53, 37, 4), Qt::white);
    sheet.plates = {{QStringLiteral("Gold"), gold}};
    const Separations without = separations(pdfOf(sheet, {.colour = &inks_}), dpi);
    sheet.settings.cutBleed = Millimetres(6);
    const Separations plates = separations(pdfOf(sheet, {.colour = &inks_}), dpi);
    QCOMPARE(plates.at("Gold"), without.at("Gold"));
    for (const char* name : {"Cyan", "Magenta", "Yellow"}) {
        QCOMPARE(ink(plates, name, box(45, 40, 0).topLeft()), 0.0); // the mask
    }
    QVERIFY(ink(plates, "Magenta", box(35, 30, 0).topLeft()) > 0.3); // the bleed
}

void PrepressTest::white_isASeparatePlate_data() {
    QTest::addColumn<bool>("first");
    QTest::newRow("printed last") << false;
    QTest::newRow("printed first") << true;
}

void PrepressTest::white_isASeparatePlate() {
    QFETCH(bool, first);
    Sheet sheet = patchSheet();
    sheet.image.fill(QColor(200, 60, 60)); // under the white, and over it
    sheet.settings.ruler = sheet.settings.jobLine = sheet.settings.marks = false;
    const Separations without = separations(pdfOf(sheet, {.colour = &inks_}), 150);
    sheet.plates = {{QStringLiteral("Opaque White"), cornerOfWhite(sheet), first}};
    const QString path = pdfOf(sheet, {.colour = &inks_});
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    const Separations plates = separations(path, 150);
    QCOMPARE(plates.size(), std::size_t(5));
    for (const auto& [name, plate] : without) {
        QCOMPARE(plates.at(name), plate); // white and colours overprint each other
    }
    QVERIFY(std::abs(ink(plates, "Opaque White", {30, 30}) - 128 / 255.0) < 0.01);
    QCOMPARE(ink(plates, "Opaque White", {300, 300}), 0.0);
    // A viewer shows the colour.
    QVERIFY(qGray(renderedPage(path, 100, QRectF(5, 5, 2, 2)).pixel(3, 3)) < 160);
    const QByteArray page = output("qpdf", {"--qdf", "--stream-data=uncompress", path, "-"});
    const QByteArray order = page.mid(page.indexOf("/Plate0 Do"));
    QVERIFY(order.indexOf("/Plate1 Do") > 0);
}

void PrepressTest::pdfTarget_keepsAllPlates_data() {
    QTest::addColumn<PdfTarget>("target");
    QTest::addColumn<bool>("blends");
    QTest::addColumn<QByteArray>("version");
    QTest::newRow("Ghostscript") << PdfTarget::Ghostscript << true << QByteArray("PDF/X-4");
    QTest::newRow("Adobe") << PdfTarget::AdobePrintEngine << false << QByteArray("PDF/X-4");
    QTest::newRow("older") << PdfTarget::OlderRip << false << QByteArray("PDF/X-1a:2003");
}

// Whatever a raster image processor expects, white and varnish remove no ink of other plates, and
// the cut contour is outside the transparency group.
void PrepressTest::pdfTarget_keepsAllPlates() {
    QFETCH(PdfTarget, target);
    QFETCH(bool, blends);
    QFETCH(QByteArray, version);
    Sheet sheet = patchSheet();
    sheet.image.fill(QColor(200, 60, 60)); // under the white, and over it
    sheet.settings.ruler = sheet.settings.jobLine = sheet.settings.marks = false;
    const Separations without = separations(pdfOf(sheet, {.colour = &inks_}), 150);
    QImage varnish(sheet.image.size(), QImage::Format_Grayscale8);
    varnish.fill(100);
    sheet.plates = {{QStringLiteral("Varnish"), varnish, true, QColor(250, 250, 250)},
                    {QStringLiteral("White"), cornerOfWhite(sheet)}};
    sheet.settings.cutLine = CutLine::Film;
    QByteArray icc = simpleCmykProfile(0.002);
    icc[8] = 2; // PDF/X-1a knows no profiles of version 4
    const PrinterColour inks(icc, RenderingIntent::RelativeColorimetric, false, "inks.icc");
    const QString path = pdfOf(sheet, {.colour = &inks, .pdfTarget = target});
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    const Separations plates = separations(path, 150);
    QCOMPARE(plates.size(), std::size_t(7));
    const QRect inside = without.begin()->second.rect().adjusted(2, 2, -2, -2); // without the cut
    for (const auto& [name, plate] : without) {
        QCOMPARE(plates.at(name).copy(inside), plate.copy(inside));
    }
    QVERIFY(std::abs(ink(plates, "Varnish", {300, 300}) - 100 / 255.0) < 0.01);
    QVERIFY(std::abs(ink(plates, "White", {30, 30}) - 128 / 255.0) < 0.01);
    QCOMPARE(ink(plates, "White", {300, 300}), 0.0);
    QVERIFY(inkedPixels(plates.at("CutContour")) > 500);
    const QByteArray document = output(
        "qpdf", {"--qdf", "--object-streams=disable", "--stream-data=uncompress", path, "-"});
    QCOMPARE(document.contains("/BM /Multiply"), blends);
    QCOMPARE(document.count("/S /Transparency"), qsizetype(blends));
    QCOMPARE(document.count("/OPM 1"), 1 + qsizetype(!blends)); // the cut contour, the plates
    QVERIFY(document.contains("/GTS_PDFXVersion (" + version + ")"));
    QCOMPARE(document.startsWith("%PDF-1.4"), target == PdfTarget::OlderRip);
    for (const char* key : {"/CreationDate (D:", "/ModDate (D:"}) { // of the project
        QCOMPARE(document.contains(key), target == PdfTarget::OlderRip);
    }
    // The contour is drawn by the page itself, after the plates.
    const QByteArray picture = blends ? "/Plates Do" : "/Plate2 Do";
    const qsizetype place = document.indexOf(picture);
    QVERIFY(place > 0);
    const qsizetype end = document.indexOf("endstream", place);
    QVERIFY(document.mid(place, end - place).contains("/Cut gs"));
    if (blends) { // a viewer shows the colour
        QVERIFY(qGray(renderedPage(path, 100, QRectF(5, 5, 2, 2)).pixel(3, 3)) < 160);
    }
}

void PrepressTest::squarePixels_tiff_hasOneResolution_data() {
    QTest::addColumn<bool>("cmyk");
    QTest::newRow("RGB") << false;
    QTest::newRow("CMYK") << true;
}

// On a printer that prints 3 % too small across and 2 % too large along, the patches have their
// true size if the file is printed at its one resolution.
void PrepressTest::squarePixels_tiff_hasOneResolution() {
    QFETCH(bool, cmyk);
    Sheet sheet = patchSheet();
    sheet.settings.ruler = sheet.settings.jobLine = sheet.settings.marks = false;
    PrintCorrection correction{.scaleX = 0.97, .scaleY = 1.02, .squarePixels = true};
    correction.colour = cmyk ? &inks_ : nullptr;
    const QString path = written(
        "square.tif", [&](QIODevice& device) { writeSheetTiff(sheet, device, correction); });
    TIFF* tiff = TIFFOpen(qPrintable(path), "r");
    QVERIFY(tiff);
    const auto close = qScopeGuard([&] { TIFFClose(tiff); });
    float x = 0, y = 0;
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x);
    TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y);
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
    QCOMPARE(x, 150.0f);
    QCOMPARE(y, 150.0f);
    const double unit = 150 / 25.4;
    QCOMPARE(int(width), int(std::lround(100 / 0.97 * unit)));
    QCOMPARE(int(height), int(std::lround(80 / 1.02 * unit)));
    // The six patches of 10 mm together, as printed.
    const int channels = cmyk ? 4 : 3;
    std::vector<uchar> row(std::size_t(TIFFScanlineSize(tiff)));
    QRect inked;
    for (std::uint32_t line = 0; line < height; ++line) {
        QCOMPARE(TIFFReadScanline(tiff, row.data(), line), 1);
        for (int column = 0; column < int(width); ++column) {
            const uchar* pixel = row.data() + column * channels;
            const int most = *std::max_element(pixel, pixel + channels);
            const int least = *std::min_element(pixel, pixel + channels);
            if (cmyk ? most > 60 : least < 180) {
                inked |= QRect(column, int(line), 1, 1);
            }
        }
    }
    QVERIFY2(std::abs(inked.width() * 0.97 / unit - 60) < 0.35,
             qPrintable(QString::number(inked.width() * 0.97 / unit)));
    QVERIFY2(std::abs(inked.height() * 1.02 / unit - 10) < 0.35,
             qPrintable(QString::number(inked.height() * 1.02 / unit)));
    correction.scaleY = correction.scaleX; // already square: nothing is resampled
    TIFF* same = TIFFOpen(
        qPrintable(written("same.tif",
                           [&](QIODevice& device) { writeSheetTiff(sheet, device, correction); })),
        "r");
    QVERIFY(same);
    TIFFGetField(same, TIFFTAG_IMAGEWIDTH, &width);
    TIFFClose(same);
    QCOMPARE(int(width), sheet.image.width());
}

// The file keeps the names and the printing order of a varnish that is printed first, a spot colour
// and white.
void PrepressTest::spotPlates_keepNamesAndOrder() {
    Sheet sheet = patchSheet();
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    const auto tinted = [&](int value) {
        QImage tint(sheet.image.size(), QImage::Format_Grayscale8);
        tint.fill(value);
        return tint;
    };
    sheet.plates = {{QStringLiteral("Pantone 485 C"), tinted(255), false, QColor(200, 60, 60)},
                    {QStringLiteral("Gloss varnish"), tinted(100), true, QColor(250, 250, 250)},
                    {QStringLiteral("White"), tinted(200)}};
    sheet.settings.cutLine = CutLine::Film;
    const QString path = pdfOf(sheet, {.colour = &inks_});
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    const Separations plates = separations(path, 150);
    QStringList names;
    for (const auto& [name, plate] : plates) {
        names << name;
    }
    QCOMPARE(names, QStringList({"Black", "CutContour", "Cyan", "Gloss varnish", "Magenta",
                                 "Pantone 485 C", "White", "Yellow"}));
    QCOMPARE(ink(plates, "Pantone 485 C", {200, 100}), 1.0);
    QVERIFY(std::abs(ink(plates, "Gloss varnish", {200, 100}) - 100 / 255.0) < 0.01);
    const QByteArray page = output("qpdf", {"--qdf", "--stream-data=uncompress", path, "-"});
    QList<qsizetype> places;
    for (const char* name : {"/Gloss#20varnish", "/Pantone#20485#20C", "/White"}) {
        places << page.indexOf(name);
        QVERIFY(places.back() > 0);
    }
    // A viewer without the ink shows its alternate colour, here over bare film.
    QVERIFY(qGray(renderedPage(path, 100, QRectF(5, 5, 2, 2)).pixel(3, 3)) < 160);
    const QString tiff = written(
        "spots.tif", [&](QIODevice& device) { writeSheetTiff(sheet, device, {.colour = &inks_}); });
    TIFF* file = TIFFOpen(qPrintable(tiff), "r");
    QVERIFY(file);
    const auto close = qScopeGuard([&] { TIFFClose(file); });
    const char* inkNames = nullptr;
    QVERIFY(TIFFGetField(file, TIFFTAG_INKNAMES, &inkNames));
    QStringList samples;
    for (int i = 0; i < 7; ++i, inkNames += std::strlen(inkNames) + 1) {
        samples << QString::fromUtf8(inkNames);
    }
    QCOMPARE(samples.mid(4), QStringList({"Pantone 485 C", "Gloss varnish", "White"}));
    std::vector<uchar> row(std::size_t(TIFFScanlineSize(file)));
    QCOMPARE(TIFFReadScanline(file, row.data(), 0), 1);
    QCOMPARE(int(row[7 * 100 + 4]), 255);
    QCOMPARE(int(row[7 * 100 + 5]), 100);
    QCOMPARE(int(row[7 * 100 + 6]), 200);
}

void PrepressTest::writeSheetTiff_white_isANamedSample() {
    Sheet sheet = patchSheet();
    sheet.plates = {{QStringLiteral("White"), cornerOfWhite(sheet)}};
    const QString path = written(
        "white.tif", [&](QIODevice& device) { writeSheetTiff(sheet, device, {.colour = &inks_}); });
    TIFF* tiff = TIFFOpen(qPrintable(path), "r");
    QVERIFY(tiff);
    const auto close = qScopeGuard([&] { TIFFClose(tiff); });
    std::uint16_t channels = 0;
    const char* names = nullptr;
    TIFFGetField(tiff, TIFFTAG_SAMPLESPERPIXEL, &channels);
    QCOMPARE(int(channels), 5);
    QVERIFY(TIFFGetField(tiff, TIFFTAG_INKNAMES, &names));
    QStringList inks;
    for (int i = 0; i < 5; ++i, names += std::strlen(names) + 1) {
        inks << QString::fromUtf8(names);
    }
    QCOMPARE(inks, QStringList({"Cyan", "Magenta", "Yellow", "Black", "White"}));
    std::vector<uchar> row(std::size_t(TIFFScanlineSize(tiff)));
    for (std::uint32_t y = 0; y <= 10; ++y) {
        QCOMPARE(TIFFReadScanline(tiff, row.data(), y), 1);
    }
    QCOMPARE(int(row[5 * 10 + 4]), 128);
    QCOMPARE(int(row[5 * 300 + 4]), 0);
}

void PrepressTest::choked_white_isSmallerOnAllSides() {
    QImage white(200, 100, QImage::Format_Grayscale8);
    white.fill(0);
    for (int y = 20; y < 80; ++y) {
        std::fill_n(white.scanLine(y) + 30, 140, uchar(200));
    }
    const QImage smaller = choked(white, 5);
    const auto at = [&](int x, int y) { return int(smaller.constScanLine(y)[x]); };
    QCOMPARE(at(34, 50), 0);
    QCOMPARE(at(35, 50), 200);
    QCOMPARE(at(164, 50), 200);
    QCOMPARE(at(165, 50), 0);
    QCOMPARE(at(100, 24), 0);
    QCOMPARE(at(100, 25), 200);
    QCOMPARE(choked(white, 0), white);
}

// The other dip prints the rest of the white there.
void PrepressTest::choked_whiteThatFadesAtSeam_keepsItsFade() {
    constexpr int left = 30, right = 170, fade = 18; // pixels
    QImage white(200, 100, QImage::Format_Grayscale8);
    white.fill(0);
    for (int y = 20; y < 80; ++y) {
        for (int x = left; x < right; ++x) {
            white.scanLine(y)[x] = uchar(std::min(200, 200 * (right - x) / fade));
        }
    }
    const QImage smaller = choked(white, 5);
    const uchar* const row = smaller.constScanLine(50);
    QCOMPARE(int(row[left + 4]), 0);
    QVERIFY(std::equal(row + left + 5, row + right, white.constScanLine(50) + left + 5));
}

void PrepressTest::writeSheetPdf_cmykTwice_givesTheSameBytes() {
    const auto bytes = [&] {
        QFile file(pdfOf(patchSheet(), {.colour = &inks_}));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray first = bytes();
    QVERIFY(first.size() > 1000);
    QCOMPARE(bytes(), first);
}

QTEST_MAIN(PrepressTest)
#include "PrepressTest.moc"
