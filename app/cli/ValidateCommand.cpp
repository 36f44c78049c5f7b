#include "cli/Arguments.h"

#include "pipeline/SheetCertainty.h"
#include "pipeline/ValidateJob.h"
#include "validation/PhysicsValidation.h"

#include <QJsonDocument>

namespace dipwright::cli {
namespace {

const QString physicsOption = QStringLiteral("physics");
const QString sheetOption = QStringLiteral("sheet");
const QString mapsOption = QStringLiteral("maps");
const QString jsonOption = QStringLiteral("json");
const QString solverOption = QStringLiteral("solver");
const QString cellsOption = QStringLiteral("cells");
const QString plotOption = QStringLiteral("plot");

// The resolutions up to the asked one.
std::vector<int> resolutions(const QCommandLineParser& parser) {
    const int finest =
        parser.isSet(cellsOption) ? wholeNumberOption(parser, cellsOption, 15, 120) : 60;
    std::vector<int> result;
    for (int cells = 15; cells <= finest; cells *= 2) {
        result.push_back(cells);
    }
    return result;
}

void validateThePhysics(const QCommandLineParser& parser, Console& console) {
    requireNoPositionalArgument(parser);
    const SolverRegistry registry;
    PhysicsOptions options;
    options.resolutions = resolutions(parser);
    const QString solver =
        parser.isSet(solverOption) ? parser.value(solverOption) : QStringLiteral("auto");
    const std::vector<PhysicsResult> results =
        validatePhysics(registry.module(solver), options, console.progress());
    if (parser.isSet(jsonOption)) {
        QJsonObject json = physicsJson(results);
        json["solver"] = registry.info(solver).id;
        console.out() << QJsonDocument(json).toJson();
    } else {
        console.out() << physicsTable(results);
    }
    if (parser.isSet(plotOption)) {
        const QString path = parser.value(plotOption);
        if (!physicsPlot(results, QSize(1400, 700)).save(path)) {
            throw Error(QStringLiteral("The plot cannot be written; name a writable .png file"),
                        path);
        }
    }
    for (const PhysicsResult& result : results) {
        if (!result.passed()) {
            throw Error(QStringLiteral("The film is farther from the closed form than allowed"),
                        result.body);
        }
    }
}

void printChange(const QString& immersion, const QString& finer, const SheetChange& change,
                 QTextStream& out) {
    out << QStringLiteral("%1  %2  %3  %4  %5  %6  %7 %\n")
               .arg(immersion, -16)
               .arg(finer, -13)
               .arg(change.median, 7, 'f', 3)
               .arg(change.percentile95, 7, 'f', 3)
               .arg(change.percentile99, 7, 'f', 3)
               .arg(change.maximum, 7, 'f', 3)
               .arg(100 * change.painted, 6, 'f', 1);
}

void printCertainty(const std::vector<ImmersionCertainty>& certainty, QTextStream& out) {
    out << "How far the sheet moves, mm\n"
           "immersion         computed with   median     95 %     99 %      max   painted\n";
    for (const ImmersionCertainty& one : certainty) {
        printChange(one.immersion.name, QStringLiteral("half the step"), one.halfStep, out);
        printChange(one.immersion.name, QStringLiteral("half the cell"), one.halfSpacing, out);
    }
    for (const QString& warning : certaintyWarnings(certainty)) {
        out << "warning: " << warning << '\n';
    }
}

void validateTheSheet(const QCommandLineParser& parser, Console& console) {
    Project project = projectArgument(parser);
    if (parser.isSet(solverOption)) {
        project.process.solver = parser.value(solverOption);
    }
    const std::vector<ImmersionCertainty> certainty =
        sheetCertainty(project, SolverRegistry(), console.progress());
    if (parser.isSet(jsonOption)) {
        console.out() << QJsonDocument(certaintyJson(certainty)).toJson();
    } else {
        printCertainty(certainty, console.out());
    }
    if (parser.isSet(mapsOption)) {
        writeCertaintyMaps(certainty, parser.value(mapsOption));
    }
}

class ValidateCommand : public Command {
public:
    QString name() const override { return QStringLiteral("validate"); }
    QString summary() const override {
        return QStringLiteral("Tells whether a project can be run, and what to look at first; "
                              "with --sheet, how far its sheets move when they are computed more "
                              "finely; or, with --physics, how far the film is from its closed "
                              "forms.");
    }
    void declare(QCommandLineParser& parser) const override {
        declareProject(parser);
        parser.addOption(
            {physicsOption, QStringLiteral("Compares the film with its closed forms instead; takes "
                                           "no project.")});
        parser.addOption(
            {sheetOption, QStringLiteral("Dips with steps half as long and with film cells half as "
                                         "wide as well, and compares the sheets. Takes some ten "
                                         "times as long as a run.")});
        parser.addOption(
            {mapsOption,
             QStringLiteral("With --sheet: draws where the sheet moves, DIR/certainty-N.png."),
             QStringLiteral("DIR")});
        parser.addOption({jsonOption, QStringLiteral("With --sheet or --physics: prints JSON.")});
        parser.addOption({solverOption,
                          QStringLiteral("With --sheet or --physics: the solver to judge."),
                          QStringLiteral("ID")});
        parser.addOption({cellsOption,
                          QStringLiteral("With --physics: the finest resolution, in grid cells in "
                                         "the contact radius (15, 30, 60 or 120; 60)."),
                          QStringLiteral("N")});
        parser.addOption({plotOption,
                          QStringLiteral("With --physics: draws simulated against exact film "
                                         "radius into a picture."),
                          QStringLiteral("FILE.png")});
    }
    void run(const QCommandLineParser& parser, Console& console) const override {
        if (parser.isSet(physicsOption) && parser.isSet(sheetOption)) {
            throw UsageError(QStringLiteral("Validate the physics or a project's sheets, not both "
                                            "at once"),
                             QStringLiteral("--physics --sheet"));
        }
        if (parser.isSet(physicsOption)) {
            validateThePhysics(parser, console);
            return;
        }
        if (parser.isSet(sheetOption)) {
            validateTheSheet(parser, console);
            return;
        }
        const Project project = projectArgument(parser);
        const SolverRegistry registry;
        for (const QString& warning : validateJob(project, registry)) {
            console.out() << "warning: " << warning << '\n';
        }
        console.out() << "The project can be run\n";
    }
};

} // namespace

std::unique_ptr<Command> validateCommand() {
    return std::make_unique<ValidateCommand>();
}

} // namespace dipwright::cli
