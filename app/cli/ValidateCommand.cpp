#include "cli/Arguments.h"

#include "base/Png.h"
#include "disk/AtomicFile.h"
#include "marks/SurfaceMask.h"
#include "pipeline/SheetNumericalError.h"
#include "pipeline/ValidateJob.h"
#include "pipeline/WriteResults.h"
#include "validation/PhysicsValidation.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <bit>

namespace dipwright::cli {
namespace {

const QString physicsOption = QStringLiteral("physics");
const QString sheetOption = QStringLiteral("sheet");
const QString mapsOption = QStringLiteral("maps");
const QString jsonOption = QStringLiteral("json");
const QString solverOption = QStringLiteral("solver");
const QString cellsOption = QStringLiteral("cells");
const QString plotOption = QStringLiteral("plot");

// Returns the resolutions to compute, from 15 cells up to the requested resolution.
std::vector<int> resolutions(const QCommandLineParser& parser) {
    const int finest =
        parser.isSet(cellsOption) ? wholeNumberOption(parser, cellsOption, 15, 120) : 60;
    if (finest % 15 != 0 || !std::has_single_bit(unsigned(finest) / 15)) {
        throw UsageError(QStringLiteral("Give 15, 30, 60 or 120 cells"),
                         QStringLiteral("--") + cellsOption);
    }
    std::vector<int> result;
    for (int cells = 15; cells <= finest; cells *= 2) {
        result.push_back(cells);
    }
    return result;
}

void validateThePhysics(const QCommandLineParser& parser, Console& console) {
    requireNoPositionalArgument(parser);
    const QString plot = pictureOption(parser, plotOption, {".png"});
    const SolverRegistry registry;
    const QString named = solverNamed(parser, registry);
    const QString solver = named.isEmpty() ? QStringLiteral("auto") : named;
    PhysicsOptions options;
    options.resolutions = resolutions(parser);
    const std::vector<PhysicsResult> results = validatePhysics(
        registry.module(solver, console.progress().cancelToken), options, console.progress());
    if (parser.isSet(jsonOption)) {
        QJsonObject json = physicsJson(results);
        json["solver"] = registry.info(solver).id;
        console.out() << QJsonDocument(json).toJson();
    } else {
        console.out() << physicsTable(results);
    }
    if (!plot.isEmpty()) {
        const QImage picture = physicsPlot(results, QSize(1400, 700));
        writeAtomically(plot, [&](QIODevice& device) { writePng(picture, device, plot); });
    }
    for (const PhysicsResult& result : results) {
        if (!result.passed()) {
            throw Error(
                QStringLiteral("The film differs from the closed form by more than the limit"),
                result.body);
        }
    }
}

void printChange(const QString& immersion, const QString& finer, const SheetChange& change,
                 QTextStream& out) {
    const auto padded = [](double number, int width, int decimals) {
        return QString::number(number, 'f', decimals).rightJustified(width);
    };
    out << QStringLiteral("%1  %2  %3  %4  %5  %6 %  %7 %\n")
               .arg(immersion.leftJustified(16), finer, padded(change.distance.mean, 7, 3),
                    padded(change.distance.percentile95, 7, 3),
                    padded(change.distance.maximum, 7, 3), padded(100 * change.painted, 6, 1),
                    padded(100 * change.paintedOnce, 5, 1));
}

void printNumericalError(const std::vector<DipNumericalError>& numericalError, QTextStream& out) {
    out << "How far the image on the sheet moves in mm, and how many per cent of the part are "
           "painted in both computations or in only one\n"
           "dip               computed with     mean     95 %      max      both      one\n";
    for (const DipNumericalError& one : numericalError) {
        printChange(one.immersion.name, QStringLiteral("half the step"), one.halfStep, out);
        printChange(one.immersion.name, QStringLiteral("half the cell"), one.halfSpacing, out);
    }
    for (const DipNumericalError& one : numericalError) {
        printWarnings(one.notes, out);
        if (!isAccurateEnough(one)) {
            out << "warning: " << one.immersion.name
                << ": the numerical error of this sheet is too large; give the film smaller cells "
                   "or more points, or turn the part\n";
        }
    }
}

void validateTheSheet(const QCommandLineParser& parser, Console& console) {
    Project project = projectArgument(parser);
    const SolverRegistry registry;
    if (const QString named = solverNamed(parser, registry); !named.isEmpty()) {
        project.process.solver = named;
    }
    if (parser.isSet(mapsOption)) {
        checkMapFolder(parser.value(mapsOption)); // fails now instead of after the computation
    }
    const std::vector<DipNumericalError> numericalError =
        sheetNumericalError(project, registry, console.progress());
    if (parser.isSet(mapsOption)) {
        writeNumericalErrorMaps(numericalError, parser.value(mapsOption));
    }
    if (parser.isSet(jsonOption)) {
        console.out() << QJsonDocument(numericalErrorJson(numericalError)).toJson();
    } else {
        printNumericalError(numericalError, console.out());
    }
}

void validateTheJob(const QCommandLineParser& parser, Console& console) {
    const Project project = projectArgument(parser);
    const QStringList warnings = validateJob(project, SolverRegistry());
    if (parser.isSet(jsonOption)) {
        const QJsonObject json{{"version", 1}, {"warnings", QJsonArray::fromStringList(warnings)}};
        console.out() << QJsonDocument(json).toJson();
        return;
    }
    printWarnings(warnings, console.out());
    if (const auto mask = surfaceMask(project.model, project.masks)) {
        console.out() << maskText(maskedAreas(*mask)) << '\n';
    }
    console.out() << "The project can be run\n";
}

class ValidateCommand : public Command {
public:
    QString name() const override { return QStringLiteral("validate"); }
    QString summary() const override {
        return QStringLiteral(
            "Checks whether a project can be run, and lists what to check first. With "
            "--sheet: the numerical error of its sheets. With --physics: the "
            "difference between the film and its closed forms.");
    }
    void declare(CommandSyntax& syntax) const override {
        declareProject(syntax);
        syntax.addOption(
            {physicsOption,
             QStringLiteral("Compares the film with its closed forms instead. Takes no project.")});
        syntax.addOption(
            {sheetOption,
             QStringLiteral(
                 "Repeats each dip with steps half as long, and once more with film cells half as "
                 "wide, and compares the sheets. Takes about ten times as long as a run.")});
        syntax.addOption(
            {mapsOption,
             QStringLiteral("With --sheet: draws maps of how far the image on the sheet moves, "
                            "DIR/certainty-N.png."),
             QStringLiteral("DIR")});
        syntax.addOption({jsonOption, QStringLiteral("Prints JSON.")});
        syntax.addOption({solverOption,
                          QStringLiteral("With --sheet or --physics: the solver to check."),
                          QStringLiteral("ID")});
        syntax.addOption({cellsOption,
                          QStringLiteral("With --physics: the finest resolution, in grid cells per "
                                         "contact radius: 15, 30, 60 or 120; default 60."),
                          QStringLiteral("N")});
        syntax.addOption(
            {plotOption,
             QStringLiteral("With --physics: plots the simulated film radius over the exact one."),
             QStringLiteral("FILE.png")});
    }
    void run(const QCommandLineParser& parser, Console& console) const override {
        requireUse(parser);
        if (parser.isSet(physicsOption)) {
            validateThePhysics(parser, console);
        } else if (parser.isSet(sheetOption)) {
            validateTheSheet(parser, console);
        } else {
            validateTheJob(parser, console);
        }
    }

private:
    // Throws UsageError for an option that has no effect here.
    static void requireUse(const QCommandLineParser& parser) {
        const bool physics = parser.isSet(physicsOption), sheet = parser.isSet(sheetOption);
        if (physics && sheet) {
            throw UsageError(QStringLiteral("Use either --physics or --sheet"),
                             QStringLiteral("--physics --sheet"));
        }
        if (physics) {
            refuseOptions(parser, {QStringLiteral("set")}, QStringLiteral("with --physics"));
        } else {
            refuseOptions(parser, {cellsOption, plotOption}, QStringLiteral("without --physics"));
        }
        if (!sheet) {
            refuseOptions(parser, {mapsOption}, QStringLiteral("without --sheet"));
        }
        if (!physics && !sheet) {
            refuseOptions(parser, {solverOption}, QStringLiteral("without --sheet or --physics"));
        }
    }
};

} // namespace

std::unique_ptr<Command> validateCommand() {
    return std::make_unique<ValidateCommand>();
}

} // namespace dipwright::cli
