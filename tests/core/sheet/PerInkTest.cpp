// Tests the inks of a CMYK printer on stretched film, each with its own law. Ghostscript separates
// the page, the laws give the inks on the part, and lcms2 gives the colours of the inks.
#include "PaperMeasure.h"
#include "TestProfiles.h"
#include "texture/Ink.h"
#include "texture/LinearLight.h"

#include "sheet/prepress/PlateCompensation.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"
#include "texture/StretchPlane.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <lcms2.h>
#include <map>

using namespace dipwright;

namespace {

using Inks = std::array<double, 4>; // 0 … 1
const QStringList inkNames{"Cyan", "Magenta", "Yellow", "Black"};

// Computes the colours of a printer's inks by lcms2.
class Print {
public:
    explicit Print(const QByteArray& icc) {
        cmsHPROFILE printer = cmsOpenProfileFromMem(icc.constData(), cmsUInt32Number(icc.size()));
        cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
        toLab_ = cmsCreateTransform(printer, TYPE_CMYK_DBL, lab, TYPE_Lab_DBL,
                                    INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
        cmsCloseProfile(lab);
        cmsCloseProfile(printer);
    }
    ~Print() { cmsDeleteTransform(toLab_); }
    Q_DISABLE_COPY_MOVE(Print)

    cmsCIELab lab(const Inks& inks) const {
        std::array<double, 4> percent{};
        std::transform(inks.begin(), inks.end(), percent.begin(),
                       [](double ink) { return 100 * ink; });
        cmsCIELab lab{};
        cmsDoTransform(toLab_, percent.data(), &lab, 1);
        return lab;
    }
    // Returns the density of one ink alone, in the primary of wide colour that the ink absorbs.
    double density(std::size_t ink, double amount) const {
        Inks alone{};
        alone[ink] = amount;
        return -std::log10(light(ink, lab(alone)) / light(ink, lab({})));
    }
    double amount(std::size_t ink, double wanted) const {
        double low = 0, high = 1;
        for (int step = 0; step < 40; ++step) {
            const double middle = (low + high) / 2;
            (density(ink, middle) < wanted ? low : high) = middle;
        }
        return low;
    }

private:
    // Returns the light in the ink's primary of BT.2020, from XYZ adapted to D50. For black,
    // returns the luminance.
    static double light(std::size_t ink, const cmsCIELab& lab) {
        cmsCIEXYZ xyz;
        cmsLab2XYZ(nullptr, &xyz, &lab);
        constexpr double rows[4][3] = {{1.6472752, -0.3936025, -0.2359803},
                                       {-0.6826037, 1.6475887, 0.0128190},
                                       {0.0296524, -0.0628993, 1.2531279},
                                       {0, 1, 0}};
        const double value = rows[ink][0] * xyz.X + rows[ink][1] * xyz.Y + rows[ink][2] * xyz.Z;
        return std::max(value, 1e-4);
    }

    cmsHTRANSFORM toLab_;
};

const QList<QColor> wantedColours{{215, 255, 255}, {150, 240, 255}, {255, 215, 255},
                                  {240, 150, 210}, {255, 255, 215}, {250, 240, 150},
                                  {220, 220, 220}, {160, 160, 160}, {120, 120, 120},
                                  {190, 140, 120}, {130, 170, 150}};
const std::array<float, 5> stretches{0.8f, 1.0f, 1.3f, 1.7f, 2.2f};
constexpr int patch = 8; // mm
constexpr int dpi = 127; // five pixels per mm

// Returns a sheet with one column for each colour and one row for each stretch.
Sheet rampSheet(const InkSettings& settings) {
    Sheet sheet;
    sheet.filmWidth = Millimetres(patch * double(wantedColours.size()));
    sheet.filmHeight = Millimetres(patch * double(stretches.size()));
    sheet.settings.resolution = DotsPerInch(dpi);
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    const QSize pixels = sheetPixels(sheet.filmWidth, sheet.filmHeight, DotsPerInch(dpi));
    QImage wanted(pixels, QImage::Format_RGBA8888);
    QImage stretch = unstretched(pixels);
    QImage printed(pixels, QImage::Format_RGBA8888); // the image for an RGB printer
    const InkCompensation compensation(settings);
    for (int y = 0; y < pixels.height(); ++y) {
        const float grown = stretches[std::size_t(std::min(y / (5 * patch), 4))];
        for (int x = 0; x < pixels.width(); ++x) {
            const QColor colour = wantedColours[std::min(x / (5 * patch), 10)];
            wanted.setPixelColor(x, y, colour);
            const LinearColour ink = compensation.print(linearColour(colour), grown).colour;
            printed.setPixelColor(
                x, y, QColor(encodedByte(ink[0]), encodedByte(ink[1]), encodedByte(ink[2])));
            reinterpret_cast<std::uint16_t*>(stretch.scanLine(y))[x] = stretchCode(grown);
        }
    }
    sheet.image = printed;
    sheet.wanted = WantedInk{wanted, stretch, settings};
    return sheet;
}

// Returns settings in which each ink has its own law; no law is the law of a dye.
InkSettings lawOfEachInk() {
    InkSettings settings;
    settings.law.exponents = {0.8, 0.4, 0.6, 0.2, 1};
    return settings;
}

} // namespace

class PerInkTest : public QObject {
    Q_OBJECT

    std::map<QString, QImage> separations(const Sheet& sheet, const PrinterColour& colour) const {
        const QTemporaryDir folder;
        QFile file(folder.filePath("sheet.pdf"));
        if (!file.open(QIODevice::WriteOnly)) {
            return {};
        }
        writeSheetPdf(sheet, file, {.colour = &colour});
        file.close();
        output("gs", {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep",
                      QString("-r%1").arg(dpi), "-o", folder.filePath("page.tif"),
                      folder.filePath("sheet.pdf")});
        std::map<QString, QImage> plates;
        for (const QString& name : inkNames) {
            plates[name] = QImage(folder.filePath(QString("page(%1).tif").arg(name)))
                               .convertToFormat(QImage::Format_Grayscale8);
        }
        return plates;
    }
    // Returns the largest ΔE between the colour shown and the separated colour, over patches
    // without full ink. Sets `counted` to the number of these patches.
    double worst(const Sheet& sheet, const PrinterColour& colour, const QByteArray& icc,
                 int& counted) const {
        const Print print(icc);
        const std::map<QString, QImage> plates = separations(sheet, colour);
        const QByteArray asked = colour.cmyk(sheet.wanted->image);
        double worst = 0;
        counted = 0;
        for (int row = 0; row < int(stretches.size()); ++row) {
            for (int column = 0; column < int(wantedColours.size()); ++column) {
                const QPoint at(5 * patch * column + 20, 5 * patch * row + 20);
                Inks wanted{}, shown{};
                bool isFull = false;
                for (std::size_t ink = 0; ink < 4; ++ink) {
                    const qsizetype pixel =
                        qsizetype(at.y()) * sheet.wanted->image.width() + at.x();
                    wanted[ink] = uchar(asked[4 * pixel + qsizetype(ink)]) / 255.0;
                    const double printed =
                        1 - qGray(plates.at(inkNames[int(ink)]).pixel(at)) / 255.0;
                    isFull = isFull || printed > 0.98;
                    const double n = sheet.wanted->settings.law.exponents[ink];
                    const double grown = double(stretches[std::size_t(row)]);
                    shown[ink] =
                        print.amount(ink, print.density(ink, printed) * std::pow(grown, -n));
                }
                if (!isFull) {
                    const cmsCIELab a = print.lab(wanted), b = print.lab(shown);
                    worst = std::max(worst, cmsDeltaE(&a, &b));
                    ++counted;
                }
            }
        }
        return worst;
    }

private Q_SLOTS:
    void plateCompensation_everyInk_showsTheWantedColour_data();
    void plateCompensation_everyInk_showsTheWantedColour();
    void plateCompensation_shown_invertsPrinted();
    void inkShortfall_fullInkTooPale_isReported();
    void separate_totalInk_holdsAfterCompensation();
    void writeSheetTiff_rgbPrinter_ignoresInkLaws();
};

void PerInkTest::plateCompensation_everyInk_showsTheWantedColour_data() {
    QTest::addColumn<QByteArray>("icc");
    QTest::newRow("simple inks") << simpleCmykProfile(0.002);
    QFile press("/usr/share/color/icc/ghostscript/default_cmyk.icc");
    if (press.open(QIODevice::ReadOnly)) {
        QTest::newRow("a press") << press.readAll();
    }
}

void PerInkTest::plateCompensation_everyInk_showsTheWantedColour() {
    QFETCH(const QByteArray, icc);
    const PrinterColour colour(icc, RenderingIntent::RelativeColorimetric, false, "inks.icc");
    Sheet sheet = rampSheet(lawOfEachInk());
    int counted = 0;
    const double after = worst(sheet, colour, icc, counted);
    // Without the wanted colours, the picture is compensated before separation, as in earlier
    // versions.
    Sheet before = sheet;
    before.wanted.reset();
    const std::map<QString, QImage> own = separations(sheet, colour);
    QVERIFY(separations(before, colour) != own);
    qInfo("worst ΔE %g of %d patches", after, counted);
    QVERIFY(counted >= 45);
    QVERIFY2(after <= 1,
             qPrintable(QStringLiteral("largest difference ΔE %1, expected 1 or less").arg(after)));
}

void PerInkTest::plateCompensation_shown_invertsPrinted() {
    const PrinterColour colour(simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                               false, "inks.icc");
    InkSettings settings = lawOfEachInk();
    settings.law.tones = {{FilmInk::Black, 0.2, 0.3, 0.1, 2.5}, {FilmInk::Black, 0.9, 0.7, 0, 2.5}};
    const PlateCompensation inks(colour, settings);
    for (int ink = 0; ink < 4; ++ink) {
        for (const float stretch : {0.7f, 1.0f, 1.5f, 2.5f}) {
            for (const int wanted : {0, 10, 60, 128}) {
                const int printed = inks.printed(ink, std::uint8_t(wanted), stretch);
                if (printed < 255) {
                    const double shown = inks.shown(ink, printed, stretch);
                    QVERIFY2(std::abs(shown - wanted) <
                                 1.2, // of 255; amounts are rounded to integers
                             qPrintable(QString("ink %1, stretch %2: %4 shown, %3 wanted, of 255")
                                            .arg(ink)
                                            .arg(double(stretch))
                                            .arg(wanted)
                                            .arg(shown)));
                    QVERIFY(!inks.fallsShort(ink, std::uint8_t(wanted), std::uint8_t(printed),
                                             stretch));
                }
            }
            QCOMPARE(int(inks.printed(ink, 0, stretch)), 0);
        }
        QCOMPARE(int(inks.printed(ink, 100, 1)), 100);
    }
}

void PerInkTest::inkShortfall_fullInkTooPale_isReported() {
    const PrinterColour colour(simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                               false, "inks.icc");
    Sheet sheet = rampSheet(lawOfEachInk());
    PrintCorrection correction{.colour = &colour};
    sheet.wanted->image.fill(QColor(200, 200, 200));
    QCOMPARE(inkShortfall(sheet, correction), 0.0);
    // One column is so dark that stretched film cannot show it.
    for (int y = 0; y < sheet.wanted->image.height(); ++y) {
        for (int x = 0; x < 5 * patch; ++x) {
            sheet.wanted->image.setPixelColor(x, y, QColor(12, 12, 12));
        }
    }
    sheet.wanted->settings.law.exponents = {1, 1, 1, 1, 1};
    const double area = inkShortfall(sheet, correction);
    const double wanted = patch * patch * (1.3 + 1.7 + 2.2);
    QVERIFY2(std::abs(area - wanted) < 0.02 * wanted,
             qPrintable(QStringLiteral("shortfall %1 mm², expected %2 mm²").arg(area).arg(wanted)));
    sheet.wanted->settings.compensate = false;
    QCOMPARE(inkShortfall(sheet, correction), 0.0);
    sheet.wanted.reset();
    QCOMPARE(inkShortfall(sheet, correction), 0.0);
}

void PerInkTest::separate_totalInk_holdsAfterCompensation() {
    const PrinterColour colour(simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                               false, "inks.icc");
    Sheet sheet = rampSheet(lawOfEachInk());
    sheet.wanted->image.fill(QColor(160, 160, 160)); // three inks of 0.65 each
    PrintCorrection correction{.colour = &colour};
    const auto mostInk = [&] {
        const QByteArray inks = separate(sheet, correction).cmyk;
        int most = 0;
        for (qsizetype pixel = 0; pixel + 3 < inks.size(); pixel += 4) {
            most = std::max(most, uchar(inks[pixel]) + uchar(inks[pixel + 1]) +
                                      uchar(inks[pixel + 2]) + uchar(inks[pixel + 3]));
        }
        return most / 255.0;
    };
    QVERIFY(mostInk() > 2.1);
    QCOMPARE(inkShortfall(sheet, correction), 0.0);
    correction.totalInk = 2.0;
    QVERIFY2(mostInk() <= 2.0,
             qPrintable(QStringLiteral("total ink %1, expected 2.0 or less").arg(mostInk())));
    QVERIFY(inkShortfall(sheet, correction) > 0);
}

// For an RGB printer, the picture is the same as without laws for each ink.
void PerInkTest::writeSheetTiff_rgbPrinter_ignoresInkLaws() {
    const Sheet sheet = rampSheet(lawOfEachInk());
    Sheet plain = sheet;
    plain.wanted.reset();
    const auto written = [](const Sheet& one, const PrintCorrection& correction) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writeSheetTiff(one, buffer, correction);
        return buffer.data();
    };
    const PrinterColour pale(paleRgbProfile(), RenderingIntent::RelativeColorimetric, true, "p");
    QCOMPARE(written(sheet, {}), written(plain, {}));
    QCOMPARE(written(sheet, {.colour = &pale}), written(plain, {.colour = &pale}));
    QVERIFY(!InkSettings().isPerInk());
}

QTEST_MAIN(PerInkTest)
#include "PerInkTest.moc"
