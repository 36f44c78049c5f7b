#include "cli/Arguments.h"
#include "cli/PrintOptions.h"

#include "base/OneLine.h"
#include "disk/AtomicFile.h"
#include "printing/Calibration.h"
#include "printing/PrintFile.h"
#include "settings/InkTones.h"
#include "sheet/page/WatchPage.h"
#include "sheet/page/WedgePage.h"
#include "sheet/prepress/PrinterColour.h"
#include "texture/LinearLight.h"
#include "texture/WedgeTable.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace dipwright::cli {
namespace {

const QString paperOption = QStringLiteral("paper");
const QString verifyOption = QStringLiteral("verify");
const QString measuredOption = QStringLiteral("measured");
const QString profileOption = QStringLiteral("profile");
const QString toOption = QStringLiteral("to");
const QString printerOption = QStringLiteral("printer");
const QString otherPaperOption = QStringLiteral("accept-other-paper");
const QString lotOption = QStringLiteral("lot");
const QString dateOption = QStringLiteral("date");

QSizeF paperSize(const QString& name) {
    for (const QPageSize& paper : calibrationPapers()) {
        if (paper.key() == name) {
            return paper.size(QPageSize::Millimeter);
        }
    }
    throw UsageError(QStringLiteral("Choose the paper A5, A4, A3, A2 or Letter"),
                     QStringLiteral("--paper %1").arg(name));
}

// Returns the profile that was found, or a new profile with this name.
PrinterProfile profileOf(const std::optional<Profile>& found, const QString& name) {
    if (found) {
        return std::get<PrinterProfile>(*found);
    }
    PrinterProfile profile;
    profile.name = name;
    return profile;
}

Millimetres parsedLength(const QString& text) {
    bool isNumber = false;
    const double length = text.trimmed().toDouble(&isNumber);
    if (!isNumber || !(length > 0 && length < 10000)) {
        throw UsageError(
            QStringLiteral("“%1” is not a length in mm; give X and Y, for example 170.7x219.4")
                .arg(text),
            QStringLiteral("--measured"));
    }
    return Millimetres(length);
}

struct Measured {
    Millimetres x, y;
};

Measured measured(const QCommandLineParser& parser) {
    const QStringList parts =
        parser.value(measuredOption).split(QRegularExpression(QStringLiteral("[x;]")));
    if (parts.size() != 2) {
        throw UsageError(QStringLiteral("Give the lengths of the horizontal and the vertical ruler "
                                        "in mm, for example 170.7x219.4"),
                         QStringLiteral("--measured"));
    }
    return {parsedLength(parts[0]), parsedLength(parts[1])};
}

// Throws UsageError if the lengths fit the page on another paper, unless --paper is given.
void requirePaperOfRulers(const Measured& lengths, const CalibrationPage& page,
                          const PrinterProfile& profile, const QCommandLineParser& parser) {
    const std::optional<QPageSize> other = otherPaperOf(profile, page, lengths.x, lengths.y);
    if (!other || parser.isSet(paperOption)) {
        return;
    }
    const QString usual = parser.value(paperOption);
    const CalibrationLengths nominal = calibrationLengths(page);
    throw UsageError(
        QStringLiteral("On %1 the rulers are %2 and %3 mm long. These lengths fit %4 better; name "
                       "the page's paper with --paper %4 or --paper %1")
            .arg(usual)
            .arg(nominal.x.value())
            .arg(nominal.y.value())
            .arg(other->key()),
        QStringLiteral("--measured"));
}

void saveScale(const Measured& lengths, const CalibrationPage& page,
               const std::optional<Profile>& known, PrinterProfile profile, QTextStream& out) {
    profile = calibrated(profile, page, lengths.x, lengths.y);
    ProfileLibrary().save(profile, known);
    out << QStringLiteral("The printer profile %1 now has the scale %2 × %3\n")
               .arg(profile.name)
               .arg(profile.scaleX, 0, 'f', 5)
               .arg(profile.scaleY, 0, 'f', 5);
}

void printRulerLengths(const CalibrationPage& page, const QCommandLineParser& parser,
                       QTextStream& out) {
    const CalibrationLengths lengths = calibrationLengths(page);
    const QString paper =
        parser.isSet(paperOption)
            ? QStringLiteral("--%1 %2 ").arg(paperOption, parser.value(paperOption))
            : QString();
    out << QStringLiteral(
               "The rulers must measure %1 and %2 mm. Measure both and enter the lengths with "
               "%3%4--measured %1x%2\n")
               .arg(lengths.x.value())
               .arg(lengths.y.value())
               .arg(paper, page.verifies() ? QStringLiteral("--verify ") : QString());
}

BoardKind boardKind(const QString& word) {
    if (word != QLatin1String("film") && word != QLatin1String("card")) {
        throw UsageError(QStringLiteral("There is no such page; choose film, card or wedge"), word);
    }
    return word == QLatin1String("film") ? BoardKind::Film : BoardKind::Card;
}

// Applies the scale of the printer profile to the page, if --profile names one.
template <typename Page>
void takeScale(Page& page, const QCommandLineParser& parser) {
    if (parser.isSet(profileOption)) {
        const auto printer = std::get<PrinterProfile>(
            ProfileLibrary().profile(ProfileKind::Printer, parser.value(profileOption)));
        page.scaleX = printer.scaleX;
        page.scaleY = printer.scaleY;
    }
}

// Writes a page for the film watch into a file.
void writeWatchPage(const QString& kind, const QCommandLineParser& parser, const QString& path,
                    QTextStream& out) {
    WatchPage page;
    page.kind = boardKind(kind);
    page.paper =
        parser.isSet(paperOption) ? paperSize(parser.value(paperOption)) : usualPaper(page.kind);
    page.lot = parser.value(lotOption);
    page.date = parser.value(dateOption);
    takeScale(page, parser);
    const WatchBoard board = watchBoard(page);
    writeAtomically(path, [&](QIODevice& device) {
        path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)
            ? writeWatchPng(page, DotsPerInch(600), device)
            : writeWatchPdf(page, device);
    });
    out << QStringLiteral("Wrote %1: %2 × %3 squares of %4 mm. Print it at true size and check "
                          "that both rulers measure %5 mm\n")
               .arg(oneLine(path))
               .arg(board.columns)
               .arg(board.rows)
               .arg(boardSquare(page.kind))
               .arg(watchRuler);
}

// Returns the colour of a patch with only cyan, magenta or yellow ink, for an RGB printer.
QColor patchColour(FilmInk ink, double density) {
    QColor colour(Qt::white);
    const auto value = float(srgbFromLinear(std::pow(10, -density)));
    switch (ink) {
    case FilmInk::Cyan:
        colour.setRedF(value);
        break;
    case FilmInk::Magenta:
        colour.setGreenF(value);
        break;
    case FilmInk::Yellow:
        colour.setBlueF(value);
        break;
    case FilmInk::Black:
    case FilmInk::White:
        break;
    }
    return colour;
}

WedgeRow rgbRow(FilmInk ink) {
    WedgeRow row{inkName(ink), {}};
    for (const double tone : wedgeTones) {
        row.patches.push_back(patchColour(ink, tone));
    }
    return row;
}

// Fills the row with the ink amounts that give each density according to the printer's ICC profile.
// The row ends at the highest density that the ink reaches.
WedgeRow inkRow(FilmInk ink, const PrinterColour& colour) {
    WedgeRow row{inkName(ink), {}};
    const std::array<float, 256> densities = colour.inkDensities(int(ink));
    for (const double tone : wedgeTones) {
        const auto above = std::lower_bound(densities.begin(), densities.end(), float(tone));
        if (above == densities.begin() || above == densities.end()) {
            break;
        }
        const float low = *(above - 1);
        const float amount =
            (float(above - densities.begin()) - 1 + (float(tone) - low) / (*above - low)) / 255;
        std::array<float, 4> inks{};
        inks[std::size_t(ink)] = amount;
        row.patches.push_back(QColor::fromCmykF(inks[0], inks[1], inks[2], inks[3]));
    }
    return row;
}

// Adds a row of patches for each ink, and returns these rows. With a CMYK ICC profile, these are
// the printer's four inks. Otherwise they are cyan, magenta and yellow, as RGB colours.
std::vector<WedgeInk> addRows(WedgePage& page, const QCommandLineParser& parser,
                              const QString& path) {
    std::optional<PrinterProfile> printer;
    if (parser.isSet(profileOption)) {
        printer = std::get<PrinterProfile>(
            ProfileLibrary().profile(ProfileKind::Printer, parser.value(profileOption)));
    }
    const std::unique_ptr<PrinterColour> colour = printerColour(printer);
    const bool inks = colour && colour->isCmyk();
    if (inks && path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
        throw UsageError(QStringLiteral("The step wedge of a CMYK printer consists of its inks, "
                                        "which PNG cannot hold; choose a file that ends in .pdf"),
                         path);
    }
    std::vector<FilmInk> order{FilmInk::Cyan, FilmInk::Magenta, FilmInk::Yellow};
    if (inks) {
        order.push_back(FilmInk::Black);
    }
    std::vector<WedgeInk> patches;
    for (const FilmInk ink : order) {
        page.rows.push_back(inks ? inkRow(ink, *colour) : rgbRow(ink));
        patches.push_back({ink, page.rows.back().patches.size()});
    }
    if (inks) {
        page.inks = colour->iccProfile();
        page.inksName = colour->description();
        qsizetype most = 0;
        for (const WedgeRow& row : page.rows) {
            most = std::max(most, qsizetype(row.patches.size()));
        }
        page.tones = page.tones.first(most);
    }
    return patches;
}

// Writes the step wedge, and next to it the table for its readings.
void writeWedgePage(const QCommandLineParser& parser, const QString& path, QTextStream& out) {
    WedgePage page;
    page.paper = paperSize(parser.value(paperOption));
    page.lot = parser.value(lotOption);
    page.date = parser.value(dateOption);
    takeScale(page, parser);
    for (const double tone : wedgeTones) {
        page.tones.append(QString::number(tone));
    }
    const std::vector<WedgeInk> patches = addRows(page, parser, path);
    const QString table = path.left(path.lastIndexOf(u'.')) + QStringLiteral(".csv");
    constexpr int stretches = 4;
    const QByteArray blank = blankWedge(patches, stretches);
    const auto isBlank = [&](const QByteArray& begin) { return begin == blank; };
    requireReplaceable(table, isBlank, QStringLiteral("the blank table for this wedge's readings"));
    writeAtomically(path, [&](QIODevice& device) {
        path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)
            ? writeWedgePng(page, DotsPerInch(600), device)
            : writeWedgePdf(page, device);
    });
    writeAtomically(table, [&](QIODevice& device) { device.write(blank); });
    out << QStringLiteral("Wrote %1 and the table for its readings, %2. Both rulers are %3 mm long "
                          "before the film is stretched\n")
               .arg(oneLine(path), oneLine(table))
               .arg(wedgeRuler);
}

void writePage(const QCommandLineParser& parser, QTextStream& out) {
    refuseOptions(parser, {measuredOption, verifyOption, printerOption, otherPaperOption},
                  QStringLiteral("with film, card or wedge"));
    const QString path =
        pictureOption(parser, toOption, {QStringLiteral(".pdf"), QStringLiteral(".png")});
    const QString kind = parser.positionalArguments().value(0);
    const bool isWedge = kind == QLatin1String("wedge");
    if (!isWedge && boardKind(kind) == BoardKind::Card) {
        refuseOptions(parser, {lotOption, dateOption}, QStringLiteral("on the card"));
    }
    if (path.isEmpty()) {
        throw UsageError(
            QStringLiteral("Name the file for the page with --to FILE.pdf or --to FILE.png"),
            QStringLiteral("--to"));
    }
    isWedge ? writeWedgePage(parser, path, out) : writeWatchPage(kind, parser, path, out);
}

class CalibrateCommand : public Command {
public:
    QString name() const override { return QStringLiteral("calibrate"); }
    QString summary() const override {
        return QStringLiteral("Calibrates a printer's scale with a page of rulers, or writes the "
                              "pages that measure a film.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("[film | card | wedge]"),
            QStringLiteral("Instead of the rulers: the chessboard to print on a film, the card "
                           "that lies beside it on the water, or the step wedge that shows how ink "
                           "thins on stretched film, with a table for its readings. Needs --to "
                           "FILE.pdf or FILE.png. --profile corrects the printer's scale. With a "
                           "CMYK ICC profile the wedge uses the printer's inks."));
        declarePrinter(syntax, QStringLiteral("Writes the page into a file instead of printing it: "
                                              "the rulers as PDF, other pages as PDF or PNG."));
        syntax.addOption({paperOption, QStringLiteral("A5, A4, A3, A2 or Letter."),
                          QStringLiteral("PAPER"), QStringLiteral("A4")});
        syntax.addOption(
            {lotOption,
             QStringLiteral("For `film` and `wedge`: the film's lot, printed on the page."),
             QStringLiteral("TEXT")});
        syntax.addOption({dateOption,
                          QStringLiteral("For `film` and `wedge`: the date, printed on the page."),
                          QStringLiteral("TEXT")});
        syntax.addOption(
            {verifyOption,
             QStringLiteral("Prints a second page that the profile has corrected. With --measured: "
                            "the lengths are from this second page.")});
        syntax.addOption({measuredOption,
                          QStringLiteral("Writes the measured lengths of the horizontal and the "
                                         "vertical ruler into the profile. Prints nothing."),
                          QStringLiteral("XxY")});
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        if (parser.positionalArguments().size() == 1) {
            writePage(parser, console.out());
            return;
        }
        requireNoPositionalArgument(parser);
        if (listsPrinters(parser)) {
            listPrinters(console.out());
            return;
        }
        refuseOptions(parser, {lotOption, dateOption}, QStringLiteral("on the page of rulers"));
        if (parser.isSet(measuredOption)) {
            refuseOptions(parser, {toOption, printerOption, otherPaperOption},
                          QStringLiteral("with --measured, which prints nothing"));
        }
        const QString name = parser.value(profileOption);
        if (name.simplified().isEmpty()) {
            throw UsageError(QStringLiteral("Name the printer profile with --profile NAME. It is "
                                            "made if it does not exist"),
                             QStringLiteral("--profile"));
        }
        const std::optional<Profile> known = ProfileLibrary().found(ProfileKind::Printer, name);
        const PrinterProfile profile = profileOf(known, name);
        const CalibrationPage page = calibrationPage(profile, paperSize(parser.value(paperOption)),
                                                     parser.isSet(verifyOption));
        if (parser.isSet(measuredOption)) {
            const Measured lengths = measured(parser);
            requirePaperOfRulers(lengths, page, profile, parser);
            saveScale(lengths, page, known, profile, console.out());
            return;
        }
        pictureOption(parser, toOption, {QStringLiteral(".pdf")});
        const PrintTarget target = printTarget(parser);
        if (!target.file.isEmpty()) {
            writeAtomically(target.file,
                            [&](QIODevice& device) { writeCalibrationPdf(page, device); });
            console.out() << wrote(target.file);
        } else {
            const auto system = printSystem();
            PrintRequest request;
            request.printer = target.printer;
            request.acceptOtherPaper = acceptsOtherPaper(parser);
            const PrintPlan plan = planCalibration(*system, page, request);
            printAndReport(*system, {plan}, console.progress(), console.out());
        }
        printRulerLengths(page, parser, console.out());
    }
};

} // namespace

std::unique_ptr<Command> calibrateCommand() {
    return std::make_unique<CalibrateCommand>();
}

} // namespace dipwright::cli
