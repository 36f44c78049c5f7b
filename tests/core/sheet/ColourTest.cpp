// Tests the sheet's colours in a printer's colour space, and the files that contain these colours.
#include "PaperMeasure.h"
#include "TestProfiles.h"

#include "base/Error.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/SheetFiles.h"

#include <QBuffer>
#include <QColorSpace>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>
#include <algorithm>
#include <cstdint>
#include <tiffio.h>

using namespace dipwright;

namespace {

QImage swatches() {
    QImage image(40, 10, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.fillRect(0, 0, 10, 10, Qt::white);
    painter.fillRect(10, 0, 10, 10, QColor(128, 128, 128));
    painter.fillRect(20, 0, 10, 10, QColor(255, 0, 0));
    return image;
}

Sheet smallSheet() {
    Sheet sheet;
    sheet.filmWidth = Millimetres(100);
    sheet.filmHeight = Millimetres(80);
    sheet.settings.resolution = DotsPerInch(150);
    sheet.image = QImage(sheetPixels(sheet.filmWidth, sheet.filmHeight, sheet.settings.resolution),
                         QImage::Format_RGBA8888);
    sheet.image.fill(Qt::transparent);
    QPainter painter(&sheet.image);
    painter.fillRect(200, 150, 200, 200, QColor(255, 0, 0));
    painter.fillRect(400, 150, 50, 200, QColor(90, 90, 90));
    sheet.job.hash = QStringLiteral("c0ffee");
    return sheet;
}

int difference(const QColor& a, const QColor& b) {
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                     std::abs(a.blue() - b.blue())});
}

struct Tiff {
    std::uint32_t width = 0, height = 0;
    std::uint16_t channels = 0, photometric = 0, unit = 0;
    float dpi = 0, dpiY = 0;
    QByteArray icc;
    QByteArray pixels;

    const uchar* pixel(int x, int y) const {
        return reinterpret_cast<const uchar*>(pixels.constData()) +
               (qsizetype(y) * width + x) * channels;
    }
};

Tiff readTiff(const QString& path) {
    Tiff result;
    TIFF* tiff = TIFFOpen(qPrintable(path), "r");
    if (!tiff) {
        return result;
    }
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &result.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &result.height);
    TIFFGetField(tiff, TIFFTAG_SAMPLESPERPIXEL, &result.channels);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &result.photometric);
    TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &result.unit);
    TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &result.dpi);
    TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &result.dpiY);
    std::uint32_t size = 0;
    void* icc = nullptr;
    if (TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &icc)) {
        result.icc = QByteArray(static_cast<const char*>(icc), qsizetype(size));
    }
    QByteArray row(TIFFScanlineSize(tiff), '\0');
    for (std::uint32_t y = 0; y < result.height; ++y) {
        TIFFReadScanline(tiff, row.data(), y, 0);
        result.pixels += row;
    }
    TIFFClose(tiff);
    return result;
}

} // namespace

class ColourTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    PrinterColour pale_{paleRgbProfile(), RenderingIntent::RelativeColorimetric, true, "pale.icc"};
    PrinterColour inks_{simpleCmykProfile(0.02), RenderingIntent::RelativeColorimetric, true,
                        "inks.icc"};

    Tiff tiffOf(const Sheet& sheet, const PrintCorrection& correction = {}) {
        QFile file(folder_.filePath("sheet.tiff"));
        if (file.open(QIODevice::WriteOnly)) {
            writeSheetTiff(sheet, file, correction);
        }
        file.close();
        return readTiff(file.fileName());
    }

    QString pdfOf(const Sheet& sheet, const PrinterColour& colour) {
        QFile file(folder_.filePath("sheet.pdf"));
        if (file.open(QIODevice::WriteOnly)) {
            writeSheetPdf(sheet, file, {.colour = &colour});
        }
        return file.fileName();
    }

private slots:
    void printerColour_profile_hasKindAndDescription();
    void printerColour_notAPrinterProfile_isRefused();
    void printerColour_greysAndReachableColours_areKept();
    void printerColour_cmyk_usesTheInksOfTheColour();
    void softProof_outOfGamut_isPaler();
    void gamutWarning_outOfGamut_isMarked();
    void writeSheetTiff_withoutProfile_isSrgb();
    void writeSheetTiff_cmykProfile_isSeparated();
    void writeSheetTiff_cmykMarks_areBlackInkOnly();
    void writeSheetTiff_printerScale_isCorrectedByResolution();
    void writeSheetTiff_twice_givesTheSameBytes();
    void writeSheetPdf_printerProfile_isOutputIntent();
    void writeSheetPdf_printerProfile_isPdfX4();
    void writeSheetPdf_screenProfile_isNotPdfX();
    void writeSheetPdf_otherDefaultSpace_keepsSrgb();
    void writeSheetTiff_spotInks_areNamedAsTiff6Requires();
};

void ColourTest::printerColour_profile_hasKindAndDescription() {
    QVERIFY(!pale_.isCmyk());
    QCOMPARE(pale_.description(), QString("Pale printer"));
    QVERIFY(inks_.isCmyk());
    QCOMPARE(inks_.description(), QString("Simple inks"));
}

void ColourTest::printerColour_notAPrinterProfile_isRefused() {
    const auto open = [](const QByteArray& bytes) {
        PrinterColour(bytes, RenderingIntent::Perceptual, true, "x.icc");
    };
    QVERIFY_EXCEPTION_THROWN(open({}), Error);
    QVERIFY_EXCEPTION_THROWN(open("not a profile"), Error);
    QVERIFY_EXCEPTION_THROWN(open(paleRgbProfile().left(300)), Error);
    QVERIFY_EXCEPTION_THROWN(open(paleRgbProfile().replace(16, 4, "\xad\x78 0")), Error);
}

void ColourTest::printerColour_greysAndReachableColours_areKept() {
    const QImage printed = pale_.rgb(swatches());
    QCOMPARE(printed.pixelColor(5, 5), QColor(Qt::white));
    QCOMPARE(printed.pixelColor(35, 5).alpha(), 0);
    const QColor grey = printed.pixelColor(15, 5);
    QVERIFY(std::abs(grey.red() - grey.blue()) <= 2 && std::abs(grey.red() - grey.green()) <= 2);
    QVERIFY(difference(pale_.softProof(swatches()).pixelColor(15, 5), QColor(128, 128, 128)) <= 2);
}

void ColourTest::printerColour_cmyk_usesTheInksOfTheColour() {
    const QByteArray inks = inks_.cmyk(swatches().convertToFormat(QImage::Format_RGB888));
    const auto* white = reinterpret_cast<const uchar*>(inks.constData()) + (5 * 40 + 5) * 4;
    const auto* red = white + 20 * 4;
    for (int ink = 0; ink < 4; ++ink) {
        QVERIFY(white[ink] <= 2);
    }
    QVERIFY(red[0] < 20);
    QVERIFY(red[1] > 230);
    QVERIFY(red[2] > 230);
}

void ColourTest::softProof_outOfGamut_isPaler() {
    const QColor red = pale_.softProof(swatches()).pixelColor(25, 5);
    QVERIFY2(red.green() > 40, qPrintable(red.name()));
    QCOMPARE(pale_.softProof(swatches()).pixelColor(35, 5).alpha(), 0);
}

void ColourTest::gamutWarning_outOfGamut_isMarked() {
    const GamutWarning warning = pale_.gamutWarning(swatches());
    QCOMPARE(qGray(warning.mask.pixel(5, 5)), 0);
    QCOMPARE(qGray(warning.mask.pixel(15, 5)), 0);
    QCOMPARE(qGray(warning.mask.pixel(25, 5)), 255);
    QCOMPARE(qGray(warning.mask.pixel(35, 5)), 0); // unprinted
    QVERIFY(std::abs(warning.share - 1.0 / 3) < 1e-9);
}

void ColourTest::writeSheetTiff_withoutProfile_isSrgb() {
    Sheet sheet = smallSheet();
    const Tiff tiff = tiffOf(sheet);
    QCOMPARE(int(tiff.width), 591);
    QCOMPARE(int(tiff.height), 472);
    QCOMPARE(int(tiff.channels), 3);
    QCOMPARE(int(tiff.photometric), int(PHOTOMETRIC_RGB));
    QCOMPARE(int(tiff.unit), int(RESUNIT_INCH));
    QCOMPARE(tiff.dpi, 150.0f);
    QCOMPARE(tiff.icc, QColorSpace(QColorSpace::SRgb).iccProfile());
    QCOMPARE(int(tiff.pixel(300, 200)[0]), 255);
    QCOMPARE(int(tiff.pixel(300, 200)[1]), 0);
    QCOMPARE(int(tiff.pixel(100, 200)[1]), 255);
    // The film's pixels are not resampled on larger paper.
    sheet.settings.marks = false;
    sheet.settings.paper = QStringLiteral("A4");
    const Tiff page = tiffOf(sheet);
    QCOMPARE(int(page.width), 1240);
    int reds = 0;
    int others = 0;
    for (int y = 400; y < 1300; ++y) {
        for (int x = 300; x < 900; ++x) {
            const uchar* p = page.pixel(x, y);
            reds += p[0] == 255 && p[1] == 0 && p[2] == 0;
            others += p[0] != 255 && p[0] != 90;
        }
    }
    QCOMPARE(reds, 200 * 200);
    QCOMPARE(others, 0);
}

void ColourTest::writeSheetTiff_cmykProfile_isSeparated() {
    const Tiff tiff = tiffOf(smallSheet(), {.colour = &inks_});
    QCOMPARE(int(tiff.channels), 4);
    QCOMPARE(int(tiff.photometric), int(PHOTOMETRIC_SEPARATED));
    QCOMPARE(tiff.icc, inks_.iccProfile());
    const uchar* red = tiff.pixel(300, 200);
    QVERIFY(red[0] < 20 && red[1] > 230 && red[2] > 230);
    QVERIFY(tiff.pixel(100, 200)[0] <= 2);
}

// Marks are in one ink, because hairlines in four inks blur if the inks are out of register.
void ColourTest::writeSheetTiff_cmykMarks_areBlackInkOnly() {
    Sheet unpainted = smallSheet();
    unpainted.image.fill(Qt::transparent);
    const Tiff onWhitePaper = tiffOf(unpainted, {.colour = &inks_});
    Sheet covered = smallSheet();
    covered.image.fill(QColor(200, 60, 60)); // the marks are on paint, with a white rim
    const Tiff onPaint = tiffOf(covered, {.colour = &inks_});
    for (const Tiff* tiff : {&onWhitePaper, &onPaint}) {
        int black = 0;
        int bare = 0;
        for (int y = 0; y < int(tiff->height); ++y) {
            for (int x = 0; x < int(tiff->width); ++x) {
                const uchar* ink = tiff->pixel(x, y);
                const bool noColour = ink[0] == 0 && ink[1] == 0 && ink[2] == 0;
                black += noColour && ink[3] > 200;
                bare += noColour && ink[3] == 0;
                QVERIFY(tiff == &onPaint || noColour);
            }
        }
        QVERIFY2(black > 300,
                 qPrintable(QStringLiteral("%1 black pixels, expected more than 300").arg(black)));
        QVERIFY(bare > 500);
    }
}

// A raster image processor prints at the size that follows from pixels and resolution. The printer
// then stretches this size.
void ColourTest::writeSheetTiff_printerScale_isCorrectedByResolution() {
    const Tiff plain = tiffOf(smallSheet());
    const Tiff corrected = tiffOf(smallSheet(), {.scaleX = 1.004, .scaleY = 0.997});
    QCOMPARE(corrected.pixels, plain.pixels);
    const double ruler = 100 / millimetresPerInch * 150; // pixels of 100 mm
    const double onPaperX = ruler / double(corrected.dpi) * millimetresPerInch * 1.004;
    const double onPaperY = ruler / double(corrected.dpiY) * millimetresPerInch * 0.997;
    QVERIFY2(std::abs(onPaperX - 100) < 0.001,
             qPrintable(QStringLiteral("100 mm are %1 mm on paper along X").arg(onPaperX)));
    QVERIFY2(std::abs(onPaperY - 100) < 0.001,
             qPrintable(QStringLiteral("100 mm are %1 mm on paper along Y").arg(onPaperY)));
}

void ColourTest::writeSheetTiff_twice_givesTheSameBytes() {
    QBuffer first;
    QBuffer second;
    first.open(QIODevice::WriteOnly);
    second.open(QIODevice::WriteOnly);
    writeSheetTiff(smallSheet(), first);
    writeSheetTiff(smallSheet(), second);
    QVERIFY(!first.data().isEmpty());
    QCOMPARE(first.data(), second.data());
    QBuffer readOnly;
    readOnly.open(QIODevice::ReadOnly);
    QVERIFY_EXCEPTION_THROWN(writeSheetTiff(smallSheet(), readOnly), Error);
}

void ColourTest::writeSheetPdf_printerProfile_isOutputIntent() {
    QFile file(folder_.filePath("pale.pdf"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    PrintCorrection correction;
    correction.colour = &pale_;
    const Sheet sheet = smallSheet();
    writeSheetPdf(sheet, file, correction);
    file.close();
    QProcess process;
    process.start("pdfimages", {"-png", file.fileName(), folder_.filePath("pale")});
    QVERIFY(process.waitForFinished(30000) && process.exitCode() == 0);
    const QImage image(folder_.filePath("pale-000.png"));
    QVERIFY(difference(image.pixelColor(300, 200), pale_.rgb(sheet.image).pixelColor(300, 200)) ==
            0);
    process.start("qpdf", {"--qdf", "--stream-data=uncompress", file.fileName(), "-"});
    QVERIFY(process.waitForFinished(30000));
    const QByteArray document = process.readAllStandardOutput();
    QVERIFY(document.contains("Pale printer"));
    QVERIFY(document.contains(pale_.iccProfile()));
}

// A print shop's preflight checks these before it accepts a file.
void ColourTest::writeSheetPdf_printerProfile_isPdfX4() {
    Sheet sheet = smallSheet();
    sheet.job.project = QStringLiteral("Turtle & Co");
    sheet.job.immersion = QStringLiteral("Top");
    sheet.job.date = QStringLiteral("2026-03-01");
    const QString path = pdfOf(sheet, pale_);
    const QByteArray info = output("pdfinfo", {"-box", path});
    QVERIFY2(info.contains("PDF/X-4"), info);
    const QByteArray xmp = output("pdfinfo", {"-meta", path});
    for (const char* words :
         {"<pdfxid:GTS_PDFXVersion>PDF/X-4<", "<pdf:Trapped>False<", "CreateDate>2026-03-01T",
          "ModifyDate>2026-03-01T", "MetadataDate>2026-03-01T", "<xmpMM:DocumentID>uuid:",
          "<xmpMM:VersionID>", "<xmpMM:RenditionClass>", "Turtle &amp; Co – Top"}) {
        QVERIFY2(xmp.contains(words), words);
    }
    QXmlStreamReader xml(xmp);
    while (!xml.atEnd()) {
        xml.readNext();
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    const QByteArray fonts = output("pdffonts", {path});
    QVERIFY2(fonts.contains(" yes ") && !fonts.contains(" no  no "), fonts); // embedded
    QVERIFY(output("qpdf", {"--json", path}).contains("\"/GTS_PDFX\""));
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
    QFile first(path);
    QVERIFY(first.open(QIODevice::ReadOnly));
    const QByteArray bytes = first.readAll();
    QFile again(pdfOf(sheet, pale_));
    QVERIFY(again.open(QIODevice::ReadOnly) && again.readAll() == bytes);
}

// PDF/X needs the profile of an output device, which a screen is not.
void ColourTest::writeSheetPdf_screenProfile_isNotPdfX() {
    const PrinterColour screen(QColorSpace(QColorSpace::AdobeRgb).iccProfile(),
                               RenderingIntent::RelativeColorimetric, true, "screen.icc");
    const QByteArray json = output("qpdf", {"--json", pdfOf(smallSheet(), screen)});
    QVERIFY(json.contains("/OutputIntent"));
    QVERIFY(!json.contains("PDFX"));
}

// Raster image processors may take RGB without a profile for colours of another space.
void ColourTest::writeSheetPdf_otherDefaultSpace_keepsSrgb() {
    QFile file(folder_.filePath("srgb.pdf"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    Sheet sheet = smallSheet();
    sheet.image.fill(QColor(200, 60, 30));
    writeSheetPdf(sheet, file);
    file.close();
    const auto rendered = [&](const QStringList& options) {
        const QString path = folder_.filePath("page.png");
        output("gs", QStringList{"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=png16m", "-r30",
                                 "-o", path} +
                         options + QStringList{file.fileName()});
        return QImage(path).pixelColor(60, 30);
    };
    QFile other(folder_.filePath("adobe.icc"));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(QColorSpace(QColorSpace::AdobeRgb).iccProfile());
    other.close();
    const QColor here = rendered({});
    const QColor there = rendered(
        {"--permit-file-read=" + other.fileName(), "-sDefaultRGBProfile=" + other.fileName()});
    QVERIFY2(difference(here, QColor(200, 60, 30)) <= 2, qPrintable(here.name()));
    QVERIFY2(difference(there, here) <= 2, qPrintable(there.name()));
}

// TIFF 6.0, section 16: the ink set CMYK has no names, and the inks of other sets are no extra
// samples.
void ColourTest::writeSheetTiff_spotInks_areNamedAsTiff6Requires() {
    Sheet sheet = smallSheet();
    sheet.plates = {
        {QStringLiteral("White"), QImage(sheet.image.size(), QImage::Format_Grayscale8)}};
    sheet.plates[0].tint.fill(90);
    QCOMPARE(int(tiffOf(sheet, {.colour = &inks_}).channels), 5);
    const QByteArray tags = output("tiffinfo", {folder_.filePath("sheet.tiff")});
    QVERIFY2(tags.contains("InkSet: 2"), tags);
    QVERIFY2(tags.contains("NumberOfInks: 5"), tags);
    QVERIFY2(tags.contains("White"), tags);
    QVERIFY2(!tags.contains("Extra Samples"), tags);
    QVERIFY2(tags.contains("Rows/Strip: 354"), tags); // of 591 × 5 bytes: 1 MiB
    QCOMPARE(int(tiffOf(smallSheet(), {.colour = &inks_}).channels), 4);
    const QByteArray cmyk = output("tiffinfo", {folder_.filePath("sheet.tiff")});
    QVERIFY2(!cmyk.contains("Ink Names") && !cmyk.contains("NumberOfInks"), cmyk);
}

QTEST_MAIN(ColourTest)
#include "ColourTest.moc"
