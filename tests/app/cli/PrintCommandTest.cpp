// Tests `dipwright-cli print`, `profile` and `calibrate` with a print system of the test's own.
#include "CliProcess.h"
#include "PaperMeasure.h"
#include "PrivateCups.h"
#include "TestFolders.h"
#include "TestProfiles.h"

#include "base/Units.h"

#include <QColorSpace>
#include <QtTest>

using namespace dipwright;
using dipwright::test::cli;
using dipwright::test::Outcome;

namespace {

const QString turtle = sampleFolder("/turtle.dipw");
// Coarse settings, to be fast. The test checks printing, not dipping.
const QStringList coarse{"--set",  "film.preset=A4",         "--set", "film.points=41x58",
                         "--set",  "body.sdf_resolution=64", "--set", "sheet.dpi=150",
                         "--quiet"};

// Returns the length from 0 to 100 mm on the ruler of a received calibration page, in mm; 0 if
// there is no ruler.
double calibrationRuler(const QString& path, bool across, int ticksWanted) {
    constexpr int dpi = 1200;
    const QImage strip =
        renderedPage(path, dpi, across ? QRectF(5, 280, 200, 10) : QRectF(7, 40, 10, 250));
    for (int line = (across ? strip.height() : strip.width()) - 1; line > 0; --line) {
        std::vector<double> ticks = darkMiddles(strip, across, line);
        if (int(ticks.size()) == ticksWanted) {
            return std::abs(ticks[100] - ticks[0]) / dpi * millimetresPerInch;
        }
    }
    return 0;
}

double rulerLength(const QString& path) {
    constexpr int dpi = 1200;
    const QImage strip = renderedPage(path, dpi, QRectF(30, 297 - 9, 150, 7));
    for (int row = strip.height() - 1; row > 0; --row) {
        const std::vector<double> ticks = darkMiddles(strip, true, row);
        if (ticks.size() == 101) {
            return (ticks.back() - ticks.front()) / dpi * millimetresPerInch;
        }
    }
    return 0;
}

} // namespace

class PrintCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<PrivateCups> cups_;

    int received() const { return int(cups_->received("pigment").size()); }

private slots:
    void initTestCase();
    void printersAreListed();
    void print_turtle_bothSheetsArrive();
    void print_chessboard_hasTrueSize();
    void calibrate_measuredRulers_makePrintsTrue();
    void print_toFile_writesSheet();
    void print_oneOfTwoDips_isTheSheetOfTheRun();
    void print_toFile_keepsPrinterMargins();
    void print_cutContourPastThePaper_isRefused();
    void print_iccProfile_convertsColours();
    void print_wideGamutProfile_keepsWideColours();
    void print_profileChangedLater_usesProjectsCopy();
    void print_refused_sendsNothing();
    void printCommands_wrongUsage_exitCodeIsTwo();
};

void PrintCommandTest::initTestCase() {
    cups_ = std::make_unique<PrivateCups>();
    QVERIFY2(cups_->problem().isEmpty(), qPrintable(cups_->problem()));
    QVERIFY(cups_->add({"pigment", true, {{"iso_a4_210x297mm", 210, 297, 0}}}));
    QVERIFY(cups_->add({"grey", false, {{"iso_a4_210x297mm", 210, 297, 0}}}));
    qputenv("DIPWRIGHT_PROFILE_PATH", folder_.filePath("profiles").toUtf8());
    qputenv("DIPWRIGHT_PRINT_HISTORY", folder_.filePath("prints").toUtf8());
}

void PrintCommandTest::printersAreListed() {
    const Outcome outcome = cli({"print", "--printers"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.out.contains("pigment: ready, colour"));
    QVERIFY(outcome.out.contains("grey: ready, grey only"));
    QVERIFY(outcome.out.contains("210 × 297 mm, borderless"));
}

void PrintCommandTest::print_turtle_bothSheetsArrive() {
    const int before = received();
    const Outcome outcome = cli(QStringList{"print", turtle, "--printer", "pigment"} + coarse);
    QVERIFY2(outcome.exitCode == 0, outcome.err);
    QCOMPARE(outcome.out.count("Printed "), 2);
    const QStringList papers = cups_->received("pigment").mid(before);
    QCOMPARE(papers.size(), 2);
    for (const QString& paper : papers) {
        QVERIFY(std::abs(pdfPage(paper).width() - 210) < 0.02);
        QVERIFY(std::abs(pdfPage(paper).height() - 297) < 0.02);
        QVERIFY(std::abs(rulerLength(paper) - 100) < 0.02);
        QVERIFY(pdfWords(paper).contains("Film A4 210 × 297 mm"));
    }
    QVERIFY(pdfWords(papers[0]) != pdfWords(papers[1])); // each sheet contains the name of its dip
    // The history lists each sheet with the job number printed on it.
    const QStringList kept = QString::fromUtf8(cli({"print", "--history"}).out).split('\n');
    for (int i : {0, 1}) {
        const QString& print = kept[1 - i]; // the history lists the newest print first
        QVERIFY2(print.contains("pigment") && print.endsWith("Printed"), qPrintable(print));
        const QString job = print.section("job ", 1).section(' ', 0, 0);
        QVERIFY2(job.size() == 12 && pdfWords(papers[i]).contains(job.toUtf8()), qPrintable(print));
    }
}

void PrintCommandTest::print_chessboard_hasTrueSize() {
    const int before = received();
    const Outcome outcome = cli(QStringList{"print", turtle, "--printer", "pigment", "--immersion",
                                            "2", "--film-image", "chessboard"} +
                                coarse);
    QVERIFY2(outcome.exitCode == 0, outcome.err);
    QCOMPARE(received(), before + 1);
    constexpr int dpi = 600;
    const QString paper = cups_->received("pigment").last();
    const QImage row = renderedPage(paper, dpi, QRectF(15, 157, 180, 1));
    const QImage column = renderedPage(paper, dpi, QRectF(113.5, 15, 1, 267));
    for (const QImage& strip : {row, column.transformed(QTransform().rotate(90))}) {
        const std::vector<double> found = edges(strip, strip.height() / 2, 0);
        QVERIFY(found.size() >= 10);
        for (std::size_t i = 1; i < found.size(); ++i) {
            const double square = (found[i] - found[i - 1]) / dpi * millimetresPerInch;
            QVERIFY2(
                std::abs(square - 17) <= 0.02,
                qPrintable(QStringLiteral("a square is %1 mm, expected 17 ± 0.02 mm").arg(square)));
        }
    }
}

// The printer scales by 1.004 × 0.997. The test measures the scale, corrects it and verifies the
// correction.
void PrintCommandTest::calibrate_measuredRulers_makePrintsTrue() {
    const int before = received();
    Outcome outcome = cli({"calibrate", "--profile", "Mine", "--printer", "pigment"});
    QVERIFY2(outcome.exitCode == 0, outcome.err);
    QVERIFY(outcome.out.contains("must measure 170 and 220 mm"));
    outcome = cli({"calibrate", "--profile", "Mine", "--measured",
                   QString("%1x%2").arg(170 * 1.004, 0, 'f', 2).arg(220 * 0.997, 0, 'f', 2)});
    QVERIFY2(outcome.out.contains("1.00400 × 0.99700"), outcome.out);
    outcome = cli({"calibrate", "--profile", "Mine", "--printer", "pigment", "--verify"});
    QVERIFY2(outcome.exitCode == 0, outcome.err);
    QVERIFY(
        outcome.out.contains("--verify --measured 170x220")); // else a new calibration would start
    const QStringList pages = cups_->received("pigment").mid(before);
    QCOMPARE(pages.size(), 2);
    QVERIFY(pdfWords(pages[0]).contains("Calibration"));
    QVERIFY(pdfWords(pages[1]).contains("Scale correction: X 1.004, Y 0.997"));
    const double first[] = {calibrationRuler(pages[0], true, 171),
                            calibrationRuler(pages[0], false, 221)};
    const double second[] = {calibrationRuler(pages[1], true, 171),
                             calibrationRuler(pages[1], false, 221)};
    const double error[] = {1.004, 0.997};
    for (int axis : {0, 1}) {
        QVERIFY2(
            std::abs(first[axis] - 100) < 0.02,
            qPrintable(QStringLiteral("ruler before the correction: %1 mm, expected 100 ± 0.02 mm")
                           .arg(first[axis])));
        const double length = second[axis] * error[axis];
        QVERIFY2(
            std::abs(length - 100) <= 0.05,
            qPrintable(QStringLiteral("ruler after the correction: %1 mm, expected 100 ± 0.05 mm")
                           .arg(length)));
    }
    outcome = cli(QStringList{"print", turtle, "--printer", "pigment", "--immersion", "1",
                              "--profile", "Mine"} +
                  coarse);
    QVERIFY2(outcome.exitCode == 0, outcome.err);
    const double rulerOnPaper = rulerLength(cups_->received("pigment").last()) * 1.004;
    QVERIFY2(
        std::abs(rulerOnPaper - 100) < 0.05,
        qPrintable(
            QStringLiteral("ruler of the sheet: %1 mm, expected 100 ± 0.05 mm").arg(rulerOnPaper)));
}

void PrintCommandTest::print_toFile_writesSheet() {
    for (const QString& name : {QString("sheet.pdf"), QString("sheet.tiff")}) {
        const QString path = folder_.filePath(name);
        const Outcome outcome =
            cli(QStringList{"print", turtle, "--immersion", "1", "--to", path} + coarse);
        QVERIFY2(outcome.exitCode == 0, outcome.err);
        QVERIFY(QFileInfo(path).size() > 10000);
        QVERIFY(cli({"print", "--history"}).out.split('\n')[0].contains(path.toUtf8()));
        const Outcome again = cli({"print", turtle, "--immersion", "1", "--to", path, "--copies",
                                   "2"}); // the sheet itself may be replaced
        QVERIFY2(again.err.contains("once"), again.err);
    }
    QVERIFY(std::abs(rulerLength(folder_.filePath("sheet.pdf")) - 100) < 0.02);
    QCOMPARE(cli({"print", turtle, "--to", folder_.filePath("both.pdf")}).exitCode, 2);
}

// Two dips share the body's surface. So the sheet of one of them depends on the other.
void PrintCommandTest::print_oneOfTwoDips_isTheSheetOfTheRun() {
    const QString results = folder_.filePath("results");
    QCOMPARE(cli(QStringList{"run", turtle, "--out", results, "--no-certainty"} + coarse).exitCode,
             0);
    QFile report(results + "/report.json");
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QJsonArray dips =
        QJsonDocument::fromJson(report.readAll()).object()["immersions"].toArray();
    QCOMPARE(dips.size(), 2);
    for (int dip = 0; dip < 2; ++dip) {
        const QString path = folder_.filePath(QStringLiteral("dip-%1.pdf").arg(dip));
        QCOMPARE(cli(QStringList{"print", turtle, "--immersion", QString::number(dip + 1), "--to",
                                 path} +
                     coarse)
                     .exitCode,
                 0);
        const QString job = dips[dip]["job"].toString();
        QVERIFY(!job.isEmpty());
        const QByteArray printed = cli({"print", "--history"}).out.split('\n')[0];
        QVERIFY2(printed.contains("job " + job.toUtf8()), printed);
    }
}

// A file for a printer is checked like a job that is sent to it.
void PrintCommandTest::print_toFile_keepsPrinterMargins() {
    QVERIFY(
        cli({"profile", "set", "printer", "Inset", "--set", "margins_mm=12;12;12;12"}).exitCode ==
        0);
    const auto write = [&](const QString& path, const QStringList& more) {
        return cli(QStringList{"print", turtle, "--immersion", "1", "--to", path} + coarse + more);
    };
    const QString pdf = folder_.filePath("inset.pdf");
    QCOMPARE(write(pdf, {"--profile", "Inset", "--accept-clipping"}).exitCode, 0);
    const QImage bottom = renderedPage(pdf, 300, QRectF(60, 297 - 11.5, 90, 11));
    for (int y = 0; y < bottom.height(); ++y) {
        QVERIFY(darkMiddles(bottom, true, y).empty());
    }
    QVERIFY(pdfWords(pdf).contains("100 mm"));
    QVERIFY(cli({"profile", "set", "printer", "Small", "--set", "scale=0.93;0.93"}).exitCode == 0);
    for (const QString& name : {QString("small.pdf"), QString("small.tiff")}) {
        const QString path = folder_.filePath(name);
        const Outcome refused =
            write(path, {"--profile", "Small", "--set", "sheet.paper=film", "--set",
                         "film.size_mm=120x200", "--film-image", "chessboard"});
        QVERIFY2(refused.exitCode == 1, refused.out);
        QVERIFY2(refused.err.contains("does not reach"), refused.err);
        QVERIFY(!QFileInfo::exists(path));
    }
    const QString pieces = folder_.filePath("pieces.pdf");
    QCOMPARE(write(pieces, {"--tile-paper", "120x160"}).exitCode, 0);
    const QByteArray info = output("pdfinfo", {pieces});
    QVERIFY2(info.contains("Pages:           6"), info);
    QCOMPARE(write(pieces, {"--tile-paper", "quarto"}).exitCode, 2);
}

// The printer prints too small, so the page is enlarged, and the film's edge with it.
void PrintCommandTest::print_cutContourPastThePaper_isRefused() {
    QFile icc(folder_.filePath("inks.icc"));
    QVERIFY(icc.open(QIODevice::WriteOnly));
    icc.write(simpleCmykProfile(0.002));
    icc.close();
    const auto write = [&](const QString& scale, const QStringList& more = {}) {
        cli({"profile", "set", "printer", "Cutter", "--icc", icc.fileName(), "--set",
             "scale=" + scale});
        return cli(QStringList{"print", turtle, "--immersion", "1", "--to",
                               folder_.filePath("cut.pdf"), "--profile", "Cutter", "--set",
                               "sheet.paper=film", "--set", "sheet.cut_line=film"} +
                   coarse + more);
    };
    QCOMPARE(write("1;1").exitCode, 0);
    const Outcome refused = write("0.97;0.97");
    QCOMPARE(refused.exitCode, 1);
    QVERIFY2(refused.err.contains("cut contour reaches past the edge"), refused.err);
    QCOMPARE(write("0.97;0.97", {"--accept-clipping"}).exitCode, 0);
    // The verdict is that of the chosen printer, which can print white.
    const Outcome white = write("1;1", {"--set", "sheet.white=last"});
    QCOMPARE(white.exitCode, 0);
    QVERIFY2(!white.out.contains("left out"), white.out);
}

// The printer's profile is Adobe RGB, in which the sheet's sRGB colours have other values.
void PrintCommandTest::print_iccProfile_convertsColours() {
    const QString icc = folder_.filePath("wide.icc");
    const QColorSpace wide(QColorSpace::AdobeRgb);
    QFile file(icc);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(wide.iccProfile());
    file.close();
    QVERIFY(cli({"profile", "set", "printer", "Wide", "--icc", icc}).exitCode == 0);
    const auto image = [&](const QStringList& profile) {
        const QString path = folder_.filePath("colour.pdf");
        const Outcome outcome =
            cli(QStringList{"print", turtle, "--immersion", "1", "--to", path} + profile + coarse);
        output("pdfimages", {"-png", path, folder_.filePath("colour")});
        return outcome.exitCode == 0 ? QImage(folder_.filePath("colour-000.png")) : QImage();
    };
    QImage expected = image({});
    QVERIFY(!expected.isNull());
    expected.setColorSpace(QColorSpace::SRgb);
    expected.convertToColorSpace(wide);
    const QImage found = image({"--profile", "Wide", "--proof", folder_.filePath("proof.png")});
    QCOMPARE(found.size(), expected.size());
    int changed = 0;
    for (int y = 0; y < found.height(); y += 3) {
        for (int x = 0; x < found.width(); x += 3) {
            const QColor a = found.pixelColor(x, y);
            const QColor b = expected.pixelColor(x, y);
            QVERIFY(std::abs(a.red() - b.red()) <= 2 && std::abs(a.green() - b.green()) <= 2 &&
                    std::abs(a.blue() - b.blue()) <= 2);
            changed += a != Qt::white && a.saturation() > 60;
        }
    }
    QVERIFY(changed > 1000);
    QCOMPARE(QImage(folder_.filePath("proof.png")).size(), found.size());
    QVERIFY(
        output("qpdf", {"--qdf", folder_.filePath("colour.pdf"), "-"}).contains(wide.iccProfile()));
}

// Adobe RGB's green is outside sRGB. No step on the way to the printer may clip it to sRGB.
void PrintCommandTest::print_wideGamutProfile_keepsWideColours() {
    const QColorSpace wide(QColorSpace::AdobeRgb);
    const QString icc = folder_.filePath("adobe.icc");
    QFile file(icc);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(wide.iccProfile());
    file.close();
    QVERIFY(cli({"profile", "set", "printer", "Adobe", "--icc", icc}).exitCode == 0);
    const QColor green(20, 230, 20);
    QImage picture(60, 80, QImage::Format_RGB888);
    picture.setColorSpace(wide);
    picture.fill(green);
    QVERIFY(picture.save(folder_.filePath("green.png")));
    for (const QString& name : {QString("wide.pdf"), QString("wide.tiff")}) {
        const QString path = folder_.filePath(name);
        const Outcome outcome =
            cli(QStringList{"print", turtle, "--immersion", "1", "--to", path, "--profile", "Adobe",
                            "--film-image", folder_.filePath("green.png")} +
                coarse);
        QVERIFY2(outcome.exitCode == 0, outcome.err);
        QVERIFY2(outcome.out.contains("0.0 % of the printed colour is out"), outcome.out);
        output("pdfimages", {"-png", path, folder_.filePath("wide")}); // from the PDF
        QImage found(name.endsWith("pdf") ? folder_.filePath("wide-000.png") : path);
        QVERIFY(!found.isNull());
        found.setColorSpace(QColorSpace()); // compares the stored values
        const QColor middle = found.pixelColor(found.width() / 2, found.height() / 2);
        QVERIFY2(middle == green, qPrintable(name + middle.name()));
    }
}

void PrintCommandTest::print_profileChangedLater_usesProjectsCopy() {
    const QString job = folder_.filePath("job.dipw");
    QVERIFY(QFile::copy(turtle, job));
    QVERIFY(cli({"profile", "set", "printer", "Old", "--set", "scale=1.004;0.997"}).exitCode == 0);
    QVERIFY(cli({"profile", "use", "printer", "Old", job}).exitCode == 0);
    const auto printed = [&](const QString& path) {
        const Outcome outcome =
            cli(QStringList{"print", job, "--immersion", "1", "--to", path} + coarse);
        QFile file(path);
        return outcome.exitCode == 0 && file.open(QIODevice::ReadOnly) ? file.readAll()
                                                                       : QByteArray();
    };
    const QString path = folder_.filePath("kept.pdf");
    const QByteArray before = printed(path);
    QVERIFY(std::abs(rulerLength(path) * 1.004 - 100) < 0.05);
    // The profile is changed, then removed. The project still uses its own copy.
    QVERIFY(cli({"profile", "set", "printer", "Old", "--set", "scale=0.98;1.02"}).exitCode == 0);
    QVERIFY(printed(folder_.filePath("next.pdf")) == before);
    QVERIFY(cli({"profile", "remove", "printer", "Old"}).exitCode == 0);
    QVERIFY(printed(folder_.filePath("after.pdf")) == before);
}

void PrintCommandTest::print_refused_sendsNothing() {
    const int before = received();
    const auto refused = [&](const QStringList& arguments, const QByteArray& word) {
        const Outcome outcome = cli(QStringList{"print", turtle, "--quiet"} + arguments);
        const bool isNamed =
            outcome.errorLines().size() == 1 && outcome.errorLines().first().contains(word);
        if (outcome.exitCode != 1 || !isNamed) {
            qWarning() << arguments << outcome.exitCode << outcome.err;
        }
        return outcome.exitCode == 1 && isNamed;
    };
    QVERIFY(refused({"--printer", "nosuch"}, "no such printer"));
    QVERIFY(refused({"--printer", "pigment", "--profile", "nosuch"}, "no printer profile"));
    QVERIFY(refused({"--printer", "pigment", "--set", "film.size_mm=300x300"},
                    "larger than every paper"));
    QVERIFY(refused(QStringList{"--printer", "grey"} + coarse, "grey only"));
    QVERIFY(cups_->command("cupsdisable", {"pigment"}));
    QVERIFY(refused({"--printer", "pigment"}, "stopped"));
    QVERIFY(cups_->command("cupsenable", {"pigment"}));
    QCOMPARE(received(), before);
    QVERIFY(cups_->received("grey").isEmpty());
}

void PrintCommandTest::printCommands_wrongUsage_exitCodeIsTwo() {
    for (const QStringList& arguments :
         {QStringList{"print", turtle},
          QStringList{"print", turtle, "--printer", "pigment", "--to", "x.pdf"},
          QStringList{"print", turtle, "--to", "x.bmp"},
          QStringList{"print", turtle, "--to", "x.pdf", "--copies", "2"},
          QStringList{"print", turtle, "--printer", "pigment", "--copies", "0"},
          QStringList{"print", turtle, "--printer", "pigment", "--immersion", "3"},
          QStringList{"profile"}, QStringList{"profile", "set", "scanner", "x"},
          QStringList{"profile", "fold"},
          QStringList{"profile", "set", "printer", "x", "--set", "scale=7;7"},
          QStringList{"calibrate"},
          QStringList{"calibrate", "--profile", "Mine", "--measured", "170"}}) {
        const Outcome outcome = cli(arguments);
        QVERIFY2(outcome.exitCode == 2,
                 qPrintable(arguments.join(' ') + QString::fromUtf8(outcome.err)));
        QCOMPARE(outcome.errorLines().size(), 1);
    }
}

QTEST_MAIN(PrintCommandTest)
#include "PrintCommandTest.moc"
