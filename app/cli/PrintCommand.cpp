#include "cli/Arguments.h"
#include "cli/PlatesFolder.h"
#include "cli/PrintOptions.h"
#include "cli/VerdictOutput.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/prepress/PrinterColour.h"

#include "base/Png.h"
#include "disk/AtomicFile.h"
#include "pipeline/DipCache.h"
#include "pipeline/JobPacking.h"
#include "pipeline/JobSheet.h"
#include "pipeline/Pipeline.h"
#include "project/FilmSizes.h"

#include <QRegularExpression>
#include <numeric>
#include <optional>

namespace dipwright::cli {
namespace {

const QString immersionOption = QStringLiteral("immersion");
const QString copiesOption = QStringLiteral("copies");
const QString tileOption = QStringLiteral("tile");
const QString tilePaperOption = QStringLiteral("tile-paper");
const QString greyOption = QStringLiteral("accept-grey");
const QString clippingOption = QStringLiteral("accept-clipping");
const QString proofOption = QStringLiteral("proof");
const QString platesOption = QStringLiteral("plates");
const QString historyOption = QStringLiteral("history");
const QString solverOption = QStringLiteral("solver");
constexpr int mostCopies = 999;

PrintRequest requestOf(const QCommandLineParser& parser, const PrintTarget& target,
                       const Project& project) {
    PrintRequest request = printRequest(parser, target, project);
    if (parser.isSet(copiesOption)) {
        request.copies = wholeNumberOption(parser, copiesOption, 1, mostCopies);
    }
    request.tilePaper = parser.value(tilePaperOption);
    request.tile = parser.isSet(tileOption) || !request.tilePaper.isEmpty();
    request.acceptMonochrome = parser.isSet(greyOption);
    request.acceptClipping = parser.isSet(clippingOption);
    request.turning = turningOnRoll(project);
    request.source = printSource(project, projectPath(parser));
    return request;
}

// Returns the size of a paper. Its name is one of those that projects use, or WIDTHxHEIGHT in mm.
QSizeF tilePaperSize(const QString& name) {
    static const QRegularExpression sizes(
        QStringLiteral("^(\\d+(?:\\.\\d+)?)x(\\d+(?:\\.\\d+)?)$"));
    static const QStringList named{QStringLiteral("A4"), QStringLiteral("A3"),
                                   QStringLiteral("Letter")};
    constexpr double largest = 5000; // mm
    const QRegularExpressionMatch match = sizes.match(name);
    const QSizeF size = match.hasMatch()
                            ? QSizeF(match.captured(1).toDouble(), match.captured(2).toDouble())
                        : named.contains(name) ? filmSize(name)
                                               : QSizeF();
    if (size.isEmpty() || std::max(size.width(), size.height()) > largest) {
        throw UsageError(
            QStringLiteral(
                "With --to, the paper must be A4, A3, Letter or WIDTHxHEIGHT in mm, up to 5000"),
            QStringLiteral("--tile-paper"));
    }
    return size;
}

PrintFileRequest fileRequest(const PrintRequest& request) {
    PrintFileRequest file;
    file.profile = request.profile;
    file.acceptClipping = request.acceptClipping;
    file.source = request.source;
    if (request.tile) {
        file.tilePaper = tilePaperSize(request.tilePaper);
    }
    return file;
}

// Returns the project's sheet without its image.
Sheet blankSheet(const Project& project) {
    Sheet blank;
    blank.filmWidth = project.film.width;
    blank.filmHeight = project.film.height;
    blank.settings = project.sheet;
    blank.job.project = project.name;
    blank.job.immersion = project.immersions.front().name; // errors name it
    return blank;
}

// Checks the file and its options before the computation. A TIFF has the pixels of the whole page.
void checkFileFirst(const QString& path, const Project& project, const PrintRequest& request) {
    if (request.copies > 1) {
        throw UsageError(QStringLiteral("A file holds each sheet once; leave out --copies, or "
                                        "print with --printer"),
                         QStringLiteral("--copies"));
    }
    if (isTiff(path) && request.tile) {
        throw UsageError(QStringLiteral("A TIFF file has no tiles; write a PDF file, or leave out "
                                        "--tile and --tile-paper"),
                         path);
    }
    checkWritable(path);
    fileRequest(request);
    const Sheet blank = blankSheet(project);
    const QSizeF page = pageSize(blank);
    if (isTiff(path)) { // only the width is limited, so the height does not matter here
        sheetPixels(Millimetres(page.width()), Millimetres(page.width()),
                    blank.settings.resolution);
    }
}

// Checks the printer and the paper with a blank sheet, so that errors appear before the
// computation.
void checkPrinterFirst(PrintSystem& system, const Project& project, const PrintRequest& request) {
    Sheet blank = blankSheet(project);
    blank.settings.resolution = DotsPerInch(30);
    blank.image = QImage(sheetPixels(blank.filmWidth, blank.filmHeight, blank.settings.resolution),
                         QImage::Format_RGBA8888);
    blank.image.fill(Qt::transparent);
    planPrints(system, {blank}, request);
}

void printSheets(PrintSystem& system, const JobResult& result, const PrintRequest& request,
                 const Progress& progress, QTextStream& out) {
    std::vector<Sheet> sheets;
    for (const ImmersionResult& immersion : result.immersions) {
        sheets.push_back(immersion.sheet);
    }
    const std::vector<PrintPlan> plans = planPrints(system, sheets, request);
    for (const PrintPlan& plan : plans) {
        for (const QString& warning : plan.warnings) {
            out << QStringLiteral("%1: %2\n").arg(plan.record->immersion, warning);
        }
    }
    printAndReport(system, plans, progress, out);
}

void writeFile(const Sheet& sheet, const PrintRequest& request, const QString& path,
               QTextStream& out) {
    for (const QString& warning :
         writePrintFile(sheet, fileRequest(request), path, PrintHistory())) {
        out << QStringLiteral("%1: %2\n").arg(sheet.job.immersion, warning);
    }
    out << wrote(path);
}

void writeProof(const Sheet& sheet, const PrintRequest& request, const QString& path) {
    const std::unique_ptr<PrinterColour> colour = printerColour(request.profile);
    const QImage proof =
        printProof(sheet, printCorrection(request.profile, colour.get()), true).page;
    writeAtomically(path, [&](QIODevice& device) { writePng(proof, device, path); });
}

void printGamutShare(const Sheet& sheet, const PrintRequest& request, QTextStream& out) {
    const std::unique_ptr<PrinterColour> colour = printerColour(request.profile);
    if (colour) {
        const double share = sheetGamut(sheet, *colour, requestedColours(sheet, *colour)).share;
        out << QStringLiteral("%1: %2 % of the printed colour is out of the printer's gamut\n")
                   .arg(sheet.job.immersion)
                   .arg(100 * share, 0, 'f', 1);
    }
}

// Returns the colours of the printer's plates. Throws Error if its profile is not in CMYK.
std::unique_ptr<PrinterColour> plateColour(const PrintRequest& request, const QString& folder) {
    std::unique_ptr<PrinterColour> colour = printerColour(request.profile);
    if (!colour || !colour->isCmyk()) {
        throw Error(QStringLiteral("Plates need a printer profile with an ICC profile in CMYK; "
                                   "choose one with --profile"),
                    folder);
    }
    return colour;
}

// Returns the index of the dip that --immersion names; none without the option.
std::optional<std::size_t> chosenDip(const QCommandLineParser& parser, const Project& project) {
    if (!parser.isSet(immersionOption)) {
        return std::nullopt;
    }
    return wholeNumberOption(parser, immersionOption, 1, int(project.immersions.size())) - 1;
}

// Returns the indices of the dips whose sheets are printed.
std::vector<std::size_t> chosenDips(std::optional<std::size_t> one, const Project& project) {
    std::vector<std::size_t> dips(one ? 1 : project.immersions.size());
    std::iota(dips.begin(), dips.end(), one.value_or(0));
    return dips;
}

// Returns the name of the file for the soft proof, or an empty string without --proof.
QString proofFile(const QCommandLineParser& parser, bool hasTwoSheets, const PrintTarget& target,
                  const PrintRequest& request) {
    const QString proof = pictureOption(parser, proofOption, {".png"});
    if (!(target.file + proof).isEmpty() && hasTwoSheets) {
        throw UsageError(QStringLiteral("The project has two sheets; choose one with --immersion"),
                         target.file.isEmpty() ? proof : target.file);
    }
    if (!proof.isEmpty() && !printerColour(request.profile)) {
        throw Error(QStringLiteral("A soft proof needs a printer profile with an ICC profile; "
                                   "choose one with --profile"),
                    proof);
    }
    if (!proof.isEmpty()) {
        checkWritable(proof); // fails now instead of after the computation
    }
    return proof;
}

// Lists the print history: one line for each print, newest first.
void listHistory(QTextStream& out) {
    for (const PrintRecord& record : PrintHistory().records()) {
        out << QStringLiteral("%1  job %2  %3 – %4  %5  %6 × %7 mm  ×%8  %9\n")
                   .arg(record.when.toString(QStringLiteral("yyyy-MM-dd HH:mm")), record.job,
                        record.project, record.immersion,
                        record.file.isEmpty() ? record.printer : record.file)
                   .arg(record.mediumSize.width())
                   .arg(record.mediumSize.height())
                   .arg(record.copies)
                   .arg(outcomeText(record));
    }
}

// Runs the job. Takes over the dips that are cached beside the project's file.
JobResult resultOf(const Project& project, const QCommandLineParser& parser,
                   const SolverRegistry& registry, Console& console, const Progress& progress) {
    JobOptions options;
    options.solver = parser.value(solverOption);
    applyFilmImage(options, parser);
    const auto cached =
        usableDips(project, registry, projectPath(parser), progress.silent(), console.warnings());
    return runJob(project, registry, options, cached.get(), progress);
}

// Throws UsageError for arguments and options that have no effect with --printers or --history.
void requireOnlyList(const QCommandLineParser& parser) {
    requireNoPositionalArgument(parser);
    const QString when =
        QStringLiteral("with --%1, which prints nothing")
            .arg(listsPrinters(parser) ? QStringLiteral("printers") : historyOption);
    if (listsPrinters(parser)) {
        refuseOptions(parser, {historyOption}, when);
    }
    refuseOptions(parser,
                  {immersionOption, copiesOption, tileOption, tilePaperOption, greyOption,
                   clippingOption, proofOption, platesOption, solverOption, QStringLiteral("set"),
                   QStringLiteral("profile"), QStringLiteral("film-image"),
                   QStringLiteral("threads")},
                  when);
    refuseTarget(parser, when);
}

class PrintCommand : public Command {
public:
    QString name() const override { return QStringLiteral("print"); }
    QString summary() const override {
        return QStringLiteral("Prints a project's sheets at true size, or lists the printers.");
    }

    void declare(CommandSyntax& syntax) const override {
        declareProject(syntax);
        declarePrinter(syntax);
        syntax.addOption(
            {historyOption, QStringLiteral("Lists all prints, newest first, with the job "
                                           "numbers on the sheets.")});
        syntax.addOption({immersionOption,
                          QStringLiteral("Prints only the sheet of this dip, 1 or 2."),
                          QStringLiteral("N")});
        syntax.addOption({copiesOption, QStringLiteral("The number of copies of each sheet."),
                          QStringLiteral("N")});
        syntax.addOption(
            {tileOption,
             QStringLiteral("Splits each sheet into tiles for the printer's largest paper.")});
        syntax.addOption(
            {tilePaperOption,
             QStringLiteral("Splits each sheet into tiles for this paper of the printer. With "
                            "--to: A4, A3, Letter or WIDTHxHEIGHT in mm."),
             QStringLiteral("NAME")});
        syntax.addOption(
            {greyOption, QStringLiteral("Prints coloured sheets on a printer without colour.")});
        syntax.addOption(
            {clippingOption,
             QStringLiteral("Accepts that colour outside the printable area is lost.")});
        syntax.addOption({proofOption,
                          QStringLiteral("Also writes a soft proof of the film image as PNG. "
                                         "Colours out of the printer's gamut are magenta."),
                          QStringLiteral("FILE")});
        syntax.addOption(
            {platesOption,
             QStringLiteral("Writes a picture of each plate, of the total ink and of "
                            "their composite, and their figures. Prints only if --printer "
                            "or --to is given, too."),
             QStringLiteral("DIR")});
        syntax.addOption({solverOption,
                          QStringLiteral("The solver plugin, instead of the project's choice."),
                          QStringLiteral("ID")});
        declareFilmImage(syntax);
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        if (listsPrinters(parser) || parser.isSet(historyOption)) {
            requireOnlyList(parser);
        }
        if (listsPrinters(parser)) {
            listPrinters(console.out());
            return;
        }
        if (parser.isSet(historyOption)) {
            listHistory(console.out());
            return;
        }
        const ThreadLimit threads = threadLimit(parser);
        const SolverRegistry registry;
        solverNamed(parser, registry); // fails now instead of after reading the project
        Project project = projectArgument(parser);
        const Millimetres clearance = markClearance(project);
        useProfile(parser, project);
        const std::optional<std::size_t> dip = chosenDip(parser, project);
        const QString plates = parser.value(platesOption);
        const bool isProofOnly = !plates.isEmpty() && !namesTarget(parser);
        if (isProofOnly) {
            const QString when = QStringLiteral("with --plates alone, which prints nothing");
            refuseOptions(parser,
                          {copiesOption, tileOption, tilePaperOption, clippingOption, greyOption},
                          when);
            refuseTarget(parser, when);
        }
        const PrintTarget target = isProofOnly ? PrintTarget() : printTarget(parser);
        const PrintRequest request = requestOf(parser, target, project);
        if (!target.file.isEmpty()) {
            checkFileFirst(target.file, project, request);
        }
        const QString proof =
            proofFile(parser, !dip && project.immersions.size() > 1, target, request);
        if (!plates.isEmpty()) {
            plateColour(request, plates);
            checkPlatesFolder(plates, chosenDips(dip, project), project.immersions.size());
        }
        std::unique_ptr<PrintSystem> system;
        if (!target.printer.isEmpty()) {
            system = printSystem();
            checkPrinterFirst(*system, project, request);
        }
        const Progress progress = console.progress();
        JobResult result = resultOf(project, parser, registry, console, progress.part(0, 0.8));
        for (ImmersionResult& immersion : result.immersions) {
            immersion.sheet.clearance = clearance; // as on traveller and cradle
        }
        for (const QString& note : result.notes) {
            console.out() << note << '\n';
        }
        printVerdict(result, console.out());
        if (!plates.isEmpty()) {
            writePlates(result, chosenDips(dip, project), *plateColour(request, plates), plates,
                        progress.part(0.8, 0.9), console.out());
        }
        if (dip) { // the other dip was needed, because the dips share the body's surface
            result.immersions = {result.immersions[*dip]};
        }
        for (const ImmersionResult& immersion : result.immersions) {
            printGamutShare(immersion.sheet, request, console.out());
        }
        if (!proof.isEmpty()) {
            writeProof(result.immersions.front().sheet, request, proof);
            console.out() << wrote(proof);
        }
        if (isProofOnly) {
            return;
        }
        if (system) {
            printSheets(*system, result, request, progress.part(0.9, 1), console.out());
            return;
        }
        writeFile(result.immersions.front().sheet, request, target.file, console.out());
    }
};

} // namespace

std::unique_ptr<Command> printCommand() {
    return std::make_unique<PrintCommand>();
}

} // namespace dipwright::cli
