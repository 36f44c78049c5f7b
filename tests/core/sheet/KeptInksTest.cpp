// Tests that amounts of ink come out of a CMYK printer as they were in a picture, by Ghostscript's
// plates, and which colours are printed in one ink alone.
#include "PaperMeasure.h"
#include "TestProfiles.h"
#include "base/Error.h"
#include "sheet/prepress/PlateCompensation.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"
#include "texture/LinearLight.h"
#include "texture/StretchPlane.h"

#include <QImageReader>
#include <QtTest>
#include <lcms2.h>
#include <random>

using namespace dipwright;

namespace {

constexpr int side = 64; // pixels

PrinterProfile printer(KeptInks kept = KeptInks::None) {
    PrinterProfile profile;
    profile.iccProfile = simpleCmykProfile(0.02);
    profile.keptInks = kept;
    return profile;
}

// An ink picture of random amounts with all kinds of sums, pure inks and bare paper among them.
QImage randomInks(const QString& space) {
    QImage inks = inkPicture({side, side}, space);
    std::mt19937 random(5);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < 4 * side; ++x) {
            const bool isBare = y % 4 == 3 && (x % 4) != x / 4 % 5;
            inks.scanLine(y)[x] = isBare ? uchar(0) : uchar(random() % 256);
        }
    }
    return inks;
}

// A sheet whose colours are all of one grey, and whose amounts of ink are those of `inks`.
Sheet sheetOf(const QImage& inks, bool compensate, float areaStretch = 1) {
    Sheet sheet;
    sheet.settings.resolution = DotsPerInch(127); // five pixels per mm
    sheet.filmWidth = sheet.filmHeight = Millimetres(side / 5.0);
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    sheet.image = QImage(side, side, QImage::Format_RGBA8888);
    sheet.image.fill(QColor(120, 120, 120));
    QImage stretch = unstretched({side, side});
    for (int y = 0; y < side; ++y) {
        auto* codes = reinterpret_cast<std::uint16_t*>(stretch.scanLine(y));
        std::fill_n(codes, side, stretchCode(areaStretch));
    }
    InkSettings settings;
    settings.compensate = compensate;
    sheet.wanted = WantedInk{sheet.image, stretch, settings, inkPlanes(inks)};
    return sheet;
}

QByteArray bytesOf(const QImage& inks) {
    QByteArray bytes;
    for (int y = 0; y < inks.height(); ++y) {
        bytes.append(reinterpret_cast<const char*>(inks.constScanLine(y)), 4 * inks.width());
    }
    return bytes;
}

QByteArray platesOf(const Sheet& sheet, const PrinterColour& colour,
                    std::optional<double> totalInk = {}) {
    PrintCorrection correction;
    correction.colour = &colour;
    correction.totalInk = totalInk;
    return separate(sheet, correction).cmyk;
}

QByteArray cmykOf(const PrinterColour& colour, const QColor& wanted) {
    QImage pixel(1, 1, QImage::Format_RGB888);
    pixel.fill(wanted);
    return colour.cmyk(pixel);
}

} // namespace

class KeptInksTest : public QObject {
    Q_OBJECT

private slots:
    void separate_amountsInThePrintersSpace_arePrintedNumberForNumber();
    void separate_amountsWithTotalInk_keepTheLimitExactly();
    void separate_amountsOnStretchedFilm_areDenserByTheirLaw();
    void separate_amountsInAnotherSpace_areSeparatedAgain();
    void separate_halfTheShare_givesHalfTheDensity();
    void convertInks_keptInks_staysPure_data();
    void convertInks_keptInks_staysPure();
    void cmyk_keptBlack_printsGreysInBlackAlone();
    void cmyk_deviceLink_isUsedForItsKindOfPictures();
    void printerColour_wrongDeviceLink_isRefused();
    void iccIdentity_otherIntentInTheHeader_isTheSame();
};

void KeptInksTest::separate_amountsInThePrintersSpace_arePrintedNumberForNumber() {
    const PrinterColour colour(printer(), {});
    const QImage inks = randomInks(iccIdentity(colour.iccProfile()));
    const Sheet sheet = sheetOf(inks, false);
    QCOMPARE(platesOf(sheet, colour), bytesOf(inks));
    QCOMPARE(platesOf(sheetOf(inks, true), colour), bytesOf(inks)); // the film has not stretched

    const QTemporaryDir folder;
    QFile file(folder.filePath("sheet.pdf"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    PrintCorrection correction;
    correction.colour = &colour;
    writeSheetPdf(sheet, file, correction);
    file.close();
    output("gs", {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep", "-r127", "-o",
                  folder.filePath("plates.tif"), file.fileName()});
    int plate = 0;
    for (const char* name : {"Cyan", "Magenta", "Yellow", "Black"}) {
        const QImage seen =
            QImage(folder.filePath(QStringLiteral("plates(%1).tif").arg(QLatin1String(name))))
                .convertToFormat(QImage::Format_Grayscale8);
        QCOMPARE(seen.size(), inks.size());
        int different = 0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                different += 255 - seen.constScanLine(y)[x] != inks.constScanLine(y)[4 * x + plate];
            }
        }
        QCOMPARE(different, 0);
        ++plate;
    }
}

void KeptInksTest::separate_amountsWithTotalInk_keepTheLimitExactly() {
    const PrinterColour colour(printer(), {});
    const QImage inks = randomInks(iccIdentity(colour.iccProfile()));
    const QByteArray wanted = bytesOf(inks), printed = platesOf(sheetOf(inks, false), colour, 2.2);
    const auto sum = [](const QByteArray& bytes, qsizetype at) {
        return uchar(bytes[at]) + uchar(bytes[at + 1]) + uchar(bytes[at + 2]) +
               uchar(bytes[at + 3]);
    };
    int limited = 0;
    for (qsizetype at = 0; at < wanted.size(); at += 4) {
        QVERIFY(sum(printed, at) <= 561); // 2.2 · 255
        if (sum(wanted, at) <= 561) {
            QCOMPARE(printed.mid(at, 4), wanted.mid(at, 4));
        } else {
            ++limited;
        }
    }
    QVERIFY(limited > 100);
}

void KeptInksTest::separate_amountsOnStretchedFilm_areDenserByTheirLaw() {
    const PrinterColour colour(printer(), {});
    QImage inks = inkPicture({side, side}, iccIdentity(colour.iccProfile()));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            inks.scanLine(y)[4 * x + y % 4] = uchar(2 * x); // one ink alone
        }
    }
    const Sheet sheet = sheetOf(inks, true, 1.5F);
    const QByteArray printed = platesOf(sheet, colour);
    const PlateCompensation law(colour, sheet.wanted->settings);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < side; ++x) {
            for (int ink = 0; ink < 4; ++ink) {
                const int amount = uchar(printed[4 * (y * side + x) + ink]);
                QVERIFY(ink == y % 4 || amount == 0); // pure inks stay pure
                QVERIFY(std::abs(law.shown(ink, amount, 1.5F) - (ink == y % 4 ? 2 * x : 0)) < 1.1);
            }
        }
    }
}

void KeptInksTest::separate_amountsInAnotherSpace_areSeparatedAgain() {
    const PrinterColour colour(printer(), {});
    const QImage inks = randomInks(iccIdentity(simpleCmykProfile(0.03)));
    const QByteArray grey = cmykOf(colour, QColor(120, 120, 120));
    QCOMPARE(platesOf(sheetOf(inks, false), colour), grey.repeated(side * side));
}

void KeptInksTest::separate_halfTheShare_givesHalfTheDensity() {
    const PrinterColour colour(printer(), {});
    QImage inks = inkPicture({side, side}, iccIdentity(colour.iccProfile()));
    for (int y = 0; y < side; ++y) {
        std::fill_n(inks.scanLine(y), 4 * side, uchar(150));
    }
    Sheet sheet = sheetOf(inks, false);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            sheet.wanted->inks.black.scanLine(y)[4 * x + 1] = 128;
        }
    }
    const QByteArray printed = platesOf(sheet, colour);
    for (int ink = 0; ink < 4; ++ink) {
        const std::array<float, 256> densities = colour.inkDensities(ink);
        const double half = double(densities[150]) * 128 / 255;
        QVERIFY(std::abs(double(densities[uchar(printed[ink])]) - half) < 0.005);
    }
}

void KeptInksTest::convertInks_keptInks_staysPure_data() {
    QTest::addColumn<int>("kept");
    QTest::addColumn<QByteArray>("amounts");
    QTest::addColumn<bool>("stays");
    const QByteArray black("\0\0\0\xc8", 4), cyan("\x50\0\0\0", 4), mixed("\x50\x50\0\0", 4);
    const int none = int(KeptInks::None), onlyBlack = int(KeptInks::Black),
              pure = int(KeptInks::Pure);
    QTest::newRow("black, none kept") << none << black << false;
    QTest::newRow("black, black kept") << onlyBlack << black << true;
    QTest::newRow("cyan, black kept") << onlyBlack << cyan << false;
    QTest::newRow("cyan, all kept") << pure << cyan << true;
    QTest::newRow("mixture, all kept") << pure << mixed << false;
}

void KeptInksTest::convertInks_keptInks_staysPure() {
    QFETCH(int, kept);
    QFETCH(QByteArray, amounts);
    QFETCH(bool, stays);
    const PrinterColour colour(printer(KeptInks(kept)), {});
    const std::array<std::uint8_t, 4> separated{1, 2, 3, 4};
    std::array<std::uint8_t, 4> inks{};
    std::copy(amounts.begin(), amounts.end(), inks.begin());
    const auto before = inks;
    colour.convertInks(inks, iccIdentity(simpleCmykProfile(0.03)), separated);
    QVERIFY(inks == (stays ? before : separated));
}

void KeptInksTest::cmyk_keptBlack_printsGreysInBlackAlone() {
    const PrinterColour mixing(printer(), {}), keeping(printer(KeptInks::Black), {});
    QCOMPARE(cmykOf(keeping, Qt::white), QByteArray(4, '\0'));
    QCOMPARE(cmykOf(keeping, Qt::black), QByteArray("\0\0\0\xff", 4));
    for (int grey = 0; grey < 256; grey += 5) {
        const QColor colour(grey, grey, grey);
        QVERIFY(cmykOf(keeping, colour).startsWith(QByteArray(3, '\0')));
        // The light is in proportion, from full black to paper.
        const double light = linearFromSrgb(grey / 255.0);
        const double wanted = 255 * srgbFromLinear(0.02 + 0.98 * light);
        const int shown = qGray(keeping.screen(cmykOf(keeping, colour), {1, 1}).pixel(0, 0));
        QVERIFY2(
            std::abs(shown - wanted) <= 2.5,
            qPrintable(QStringLiteral("%1: %2 instead of %3").arg(grey).arg(shown).arg(wanted)));
    }
    const QColor brown(150, 100, 60);
    QCOMPARE(cmykOf(keeping, brown), cmykOf(mixing, brown));
}

void KeptInksTest::cmyk_deviceLink_isUsedForItsKindOfPictures() {
    const QTemporaryDir folder;
    const auto written = [&](const char* name, const QByteArray& bytes) {
        QFile file(folder.filePath(QLatin1String(name)));
        file.open(QIODevice::WriteOnly);
        file.write(bytes);
        return file.fileName();
    };
    const auto read = [](const QString& path) {
        QFile file(path);
        file.open(QIODevice::ReadOnly);
        return file.readAll();
    };
    const QString other = written("other.icc", simpleCmykProfile(0.2));
    const QString own = written("own.icc", simpleCmykProfile(0.02));
    const QString rgbLink = folder.filePath("rgb.icc"), cmykLink = folder.filePath("cmyk.icc");
    // Links to another printer, so that the link shows. 1: relative colorimetric
    output("linkicc", {"-o", rgbLink, "-t1", "*sRGB", other});
    output("linkicc", {"-o", cmykLink, "-t1", own, other});

    PrinterProfile profile = printer();
    profile.deviceLink = read(rgbLink);
    QVERIFY(!profile.deviceLink.isEmpty());
    const PrinterColour byRgb(profile, {});
    const PrinterColour there(simpleCmykProfile(0.2), RenderingIntent::RelativeColorimetric, false,
                              {});
    for (const QColor& wanted :
         {QColor(200, 120, 90), QColor(90, 160, 200), QColor(230, 230, 230)}) {
        const QByteArray linked = cmykOf(byRgb, wanted), right = cmykOf(there, wanted);
        for (int ink = 0; ink < 4; ++ink) {
            QVERIFY(std::abs(uchar(linked[ink]) - uchar(right[ink])) <= 2);
        }
    }
    // Amounts of ink are not of the link's kind, and stay as they are.
    const QString space = iccIdentity(profile.iccProfile);
    std::array<std::uint8_t, 4> amounts{100, 20, 30, 40};
    const auto before = amounts;
    byRgb.convertInks(amounts, space, before);
    QVERIFY(amounts == before);

    profile.deviceLink = read(cmykLink);
    const PrinterColour byCmyk(profile, {});
    QCOMPARE(cmykOf(byCmyk, QColor(200, 120, 90)),
             cmykOf(PrinterColour(printer(), {}), QColor(200, 120, 90)));
    byCmyk.convertInks(amounts, space, before);
    QVERIFY(amounts != before);
    QCOMPARE(int(amounts[3]), 0); // the other printer uses no black
}

void KeptInksTest::printerColour_wrongDeviceLink_isRefused() {
    PrinterProfile profile = printer();
    for (const QByteArray& link : {QByteArray("no profile"), simpleCmykProfile(0.02)}) {
        profile.deviceLink = link;
        QVERIFY_EXCEPTION_THROWN(PrinterColour(profile, "link"), Error);
    }
}

void KeptInksTest::iccIdentity_otherIntentInTheHeader_isTheSame() {
    const QByteArray profile = simpleCmykProfile(0.02);
    QByteArray other = profile;
    other[67] = '\3'; // the rendering intent
    QCOMPARE(iccIdentity(other), iccIdentity(profile));
    other[200] = char(other[200] + 1);
    QVERIFY(iccIdentity(other) != iccIdentity(profile));
    QVERIFY(iccIdentity({}).isEmpty());
}

QTEST_MAIN(KeptInksTest)
#include "KeptInksTest.moc"
