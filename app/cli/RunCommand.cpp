#include "base/NumberText.h"
#include "cli/Arguments.h"
#include "cli/VerdictOutput.h"
#include "project/NewProject.h"
#include "project/Profiles.h"

#include "base/Error.h"
#include "base/OneLine.h"
#include "cost/CostText.h"
#include "dip/FilmUnderBody.h"
#include "marks/SurfaceMask.h"
#include "outputs/MakeOutputs.h"
#include "parallel/Tasks.h"
#include "pipeline/DipCache.h"
#include "pipeline/JobCost.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SmallerFilm.h"
#include "pipeline/WriteResults.h"
#include "project/ProjectStore.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include <algorithm>
#include <span>

namespace dipwright::cli {
namespace {

const QString outOption = QStringLiteral("out");
const QString solverOption = QStringLiteral("solver");
const QString dpiOption = QStringLiteral("dpi");
const QString numericalErrorOption = QStringLiteral("no-certainty");
const QString cradleOption = QStringLiteral("cradle");
const QString motionOption = QStringLiteral("motion-template");
const QString languageOption = QStringLiteral("language");
const QString lawsOption = QStringLiteral("laws");
const QString tolerancesOption = QStringLiteral("tolerances");
const QString untilOption = QStringLiteral("until");
const QString workOption = QStringLiteral("work");
const QString outputsOption = QStringLiteral("outputs");
const QString overwriteOption = QStringLiteral("overwrite");
const QString clippingOption = QStringLiteral("accept-clipping");

constexpr std::size_t mostPlaces = 8; // number of unreached places that are listed

// Standard output is in the language of --language.
struct Text {
    Q_DECLARE_TR_FUNCTIONS(RunCommand)
};

QString number(double value, int decimals) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return withMinusSign(locale.toString(value, 'f', decimals));
}

QString area(double value) {
    return Text::tr("%1 mm²").arg(number(value, 0));
}

void printPlaces(const ImmersionResult& result, QTextStream& out) {
    const Coverage& coverage = *result.coverage;
    if (coverage.marked.any > 0) {
        out << QStringLiteral("%1: %2\n")
                   .arg(result.immersion.name, markedText(coverage.marked, coverage.paintedArea));
    }
    if (result.verdict.advice <= Advice::Print) {
        return;
    }
    for (const PlaceToCheck& place : result.verdict.places) {
        out << "  "
            << Text::tr("x %1 mm, z %2 mm from the film's centre: %3")
                   .arg(number(double(place.rest.x()), 0), number(double(place.rest.y()), 0),
                        placeText(place, millimetres, area))
            << '\n';
    }
}

void printLaws(const std::vector<LawChange>& laws, QTextStream& out) {
    for (const LawChange& law : laws) {
        out << QStringLiteral("  %1\n").arg(lawText(law, millimetres));
    }
}

void printTolerances(const DipTolerances& tolerances, QTextStream& out) {
    const auto listed = [](const Spread& spread) {
        return Text::tr("±%1 mm (95 %; half of the painted area within ±%2 mm, all within ±%3 mm)")
            .arg(number(spread.percentile95, 2), number(spread.median, 2),
                 number(spread.maximum, 2));
    };
    out << "  " << Text::tr("colours land within %1 of their places").arg(listed(tolerances.spread))
        << '\n';
    for (const Contribution& contribution : tolerances.contributions) {
        out << "    "
            << Text::tr("%1 ±%2 %3: %4 % of the spread, %5")
                   .arg(contributorText(contribution.contributor))
                   .arg(QLocale().toString(contribution.tolerance))
                   .arg(contributorUnit(contribution.contributor),
                        number(100 * contribution.share, 1), listed(contribution.spread))
            << '\n';
        if (contribution.lost + contribution.gained >= 1) { // mm²
            out << "      "
                << Text::tr("moves the border of the paint: %1 mm² less or %2 mm² more painted")
                       .arg(number(contribution.lost, 0), number(contribution.gained, 0))
                << '\n';
        }
    }
    for (const WorstPlace& worst : tolerances.worst) {
        out << "    "
            << Text::tr("±%1 mm at x %2 mm, y %3 mm, z %4 mm on the model, largest cause: %5")
                   .arg(number(worst.spread, 2), number(double(worst.place.x()), 1),
                        number(double(worst.place.y()), 1), number(double(worst.place.z()), 1),
                        contributorText(worst.contributor))
            << '\n';
    }
    if (tolerances.sampled) {
        out << QStringLiteral("  %1\n").arg(sampledText(*tolerances.sampled, millimetres));
    }
}

void printZones(const std::vector<ZoneVerdict>& zones, QTextStream& out) {
    for (const ZoneVerdict& zone : zones) {
        out << zoneText(zone, millimetres) << '\n';
    }
}

void printShare(const JobResult& result, QTextStream& out) {
    const ShareAreas& areas = result.share->areas;
    const auto part = [&](double value) {
        return Text::tr("%1 mm² (%2 %)")
            .arg(number(value, 0), number(100 * value / areas.total(), 1));
    };
    out << Text::tr("Split between the dips: %1 %2, %3 %4, overlap %5 with a width of %6 to %7 mm, "
                    "not painted %8")
               .arg(result.immersions[0].immersion.name, part(areas.first),
                    result.immersions[1].immersion.name, part(areas.second), part(areas.both),
                    number(result.share->overlap.least, 1), number(result.share->overlap.most, 1),
                    part(areas.none))
        << '\n';
    const std::vector<UnpaintedPlace> places = unreachedPlaces(result);
    const std::size_t listed = std::min(places.size(), mostPlaces);
    for (const UnpaintedPlace& place : std::span(places).first(listed)) {
        out << "  "
            << Text::tr("not reached: %1 mm² at x %2 mm, y %3 mm, z %4 mm on the model")
                   .arg(number(place.area, 0), number(double(place.place.x()), 1),
                        number(double(place.place.y()), 1), number(double(place.place.z()), 1))
            << '\n';
    }
    if (listed < places.size()) {
        out << "  "
            << Text::tr("smaller places that only report.json lists: %1")
                   .arg(places.size() - listed)
            << '\n';
    }
    const double equator = result.share->equator.cost;
    const QString length = number(result.share->cost.length, 0);
    out << (equator > 0
                ? Text::tr("Seam: %1 mm long, %2 % as visible as a plain cut halfway between the "
                           "poses")
                      .arg(length, number(100 * result.share->cost.cost / equator, 0))
                : Text::tr("Seam: %1 mm long").arg(length))
        << '\n';
}

void printCradle(const QString& name, const Cradle& cradle, QTextStream& out) {
    if (!cradle.mesh.triangles.empty()) {
        const CradleCheck& check = cradle.check;
        out << Text::tr("%1: the cradle is %2 mm from the part and %3 mm from the paint, supports "
                        "%4 mm² of the part and may be tilted by %5°")
                   .arg(name, number(check.leastGap, 2), number(check.paintGap, 1),
                        number(check.seatArea, 0), number(check.standing.tiltDegrees, 0))
            << '\n';
    }
    for (const QString& note : cradle.notes) {
        out << QStringLiteral("  %1\n").arg(note);
    }
}

void printFilm(const ImmersionResult& result, QTextStream& out) {
    const DippedFilm& film = result.laid->film();
    const QString steps =
        film.wallSeconds > 0
            ? Text::tr("%1 steps in %2 s").arg(film.steps).arg(number(film.wallSeconds, 2))
            : Text::tr("%1 steps").arg(film.steps);
    out << Text::tr(
               "%1: %2 × %3 points, cells of %4 mm over the part, %5, coverage %6 %, read-back "
               "error of the texture %7 mm (95 %)")
               .arg(result.immersion.name)
               .arg(film.grid.columns)
               .arg(film.grid.rows)
               .arg(number(film.grid.leastSpacing(), 2), steps,
                    number(100 * result.coverage->share, 1),
                    number(result.readBack->percentile95, 3))
        << '\n';
}

void printSummary(const JobResult& result, QTextStream& out) {
    out << Text::tr("Solver: %1 %2 on %3")
               .arg(result.solver.name, result.solver.version, result.solver.device)
        << '\n';
    out << (hasMeasuredSwell(result.project.film, result.project.profiles)
                ? Text::tr("Film: swell measured on %1")
                      .arg(result.project.profiles.film->measured.date)
                : Text::tr("Film: swell guessed"))
        << '\n';
    for (const QString& note : result.notes) {
        out << note << '\n';
    }
    printVerdict(result, out);
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& immersion = result.immersions[i];
        printFilm(immersion, out);
        printPlaces(immersion, out);
        printLaws(immersion.laws, out);
        if (result.tolerances) {
            printTolerances(result.tolerances->dips[i], out);
        }
    }
    if (result.share) {
        printShare(result, out);
    }
    for (std::size_t i = 0; i < result.cradles.size(); ++i) {
        printCradle(result.immersions[i].immersion.name, result.cradles[i], out);
    }
    if (result.tolerances) {
        printZones(result.tolerances->zones, out);
    }
    if (const std::optional<SmallerFilm> smaller = smallerFilm(result)) {
        out << Text::tr(
                   "%1 % of the film is used; the smaller size %2 (%3 × %4 mm) is large enough")
                   .arg(number(100 * filmUsed(result), 0), smaller->format,
                        number(smaller->width.value(), 0), number(smaller->height.value(), 0))
            << '\n';
    }
    if (result.mask) {
        out << maskText(maskedAreas(*result.mask)) << '\n';
    }
    out << Text::tr("Coverage by all dips: %1 %").arg(number(100 * result.coverageTotal, 1))
        << '\n';
    if (const auto costs = jobCosts(result, result.project); tellsCost(costs)) {
        out << costSentence(costs.back()) << '\n';
    }
}

// Sets the language of all texts that core produces.
void setLanguage(const QString& code) {
    const QStringList known{QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("pt_BR")};
    auto* words = new QTranslator(QCoreApplication::instance());
    if (!known.contains(code) ||
        (code != known.first() &&
         !words->load(QStringLiteral(":/translations/dipwright_") + code))) {
        throw UsageError(QStringLiteral("There is no language %1; choose one of %2")
                             .arg(code, known.join(QStringLiteral(", "))),
                         QStringLiteral("--language"));
    }
    QLocale::setDefault(QLocale(code));
    QCoreApplication::installTranslator(words);
}

// Applies --until and --work to the project's film.
void applyRefinement(Project& project, const QCommandLineParser& parser) {
    if (parser.isSet(workOption)) {
        setByOption(project, QStringLiteral("film.work_million"), parser.value(workOption),
                    QStringLiteral("--work"));
    }
    if (!parser.isSet(untilOption)) {
        return;
    }
    if (parser.value(untilOption) != QLatin1String("print")) {
        throw UsageError(
            QStringLiteral("“%1” is not known; write --until print").arg(parser.value(untilOption)),
            QStringLiteral("--until"));
    }
    if (parser.isSet(numericalErrorOption)) {
        throw UsageError(QStringLiteral("--until print needs the numerical error; leave out "
                                        "--no-certainty"),
                         QStringLiteral("--until"));
    }
    if (!isRefinable(project.film)) {
        throw UsageError(
            QStringLiteral("--until print needs automatic cells and a work limit above 0; "
                           "add --set film.resolution=automatic, and --work %1 if "
                           "the limit is 0")
                .arg(int(newProjectFilmWork)),
            QStringLiteral("--until"));
    }
    project.film.wantedError.reset();
}

// Returns the outputs that --outputs names. If the command runs several projects, each may have its
// own output sets, so a wrong name is then a failure of one project.
std::vector<Output> wantedOutputs(const Project& project, const QCommandLineParser& parser) {
    const QString name = parser.value(outputsOption);
    const auto outputs = [&] { return outputsNamed(project, name); };
    return projectPaths(parser).size() > 1 ? outputs()
                                           : asUsage(QStringLiteral("--outputs"), outputs);
}

// Makes the outputs that --outputs names, in this folder. Throws Error if one of them fails.
void writeOutputs(const JobResult& result, const QString& folder, const QString& project,
                  const QCommandLineParser& parser, const Progress& progress, QTextStream& out) {
    const OutputRequest request{folder, wantedOutputs(result.project, parser), project,
                                parser.isSet(overwriteOption), parser.isSet(clippingOption)};
    int failed = 0;
    QStringList earlier;
    for (const OutputStatus& status : makeOutputs(result, request, progress)) {
        out << statusText(status) << '\n';
        if (status.state == OutputState::Failed) {
            ++failed;
            earlier += status.files;
        }
    }
    if (failed > 0) {
        const QString remaining =
            QStringLiteral("; these files in the folder may be from an earlier run: ") +
            earlier.join(QStringLiteral(", "));
        throw Error(QStringLiteral("%1 of %2 outputs failed; the reasons are listed above")
                            .arg(failed)
                            .arg(request.outputs.size()) +
                        (earlier.isEmpty() ? QString() : remaining),
                    folder);
    }
}

void require(std::optional<Advice> required, const std::vector<Advice>& verdicts,
             const QString& folder) {
    const auto fails = [&](Advice verdict) { return required && isWorse(verdict, *required); };
    const auto failed = std::count_if(verdicts.begin(), verdicts.end(), fails);
    if (failed > 0) {
        throw VerdictError(
            std::ranges::all_of(verdicts,
                                [](Advice verdict) { return verdict == Advice::NotJudged; })
                ? QStringLiteral("Without an estimate of the numerical error (--no-certainty), no "
                                 "sheet meets --require; the results are written")
            : verdicts.size() == 1
                ? QStringLiteral("The verdict is “%1”, which is worse than required; the "
                                 "results are written")
                      .arg(adviceText(verdicts.front()))
                : QStringLiteral("%1 of %2 verdicts are worse than required; the results are "
                                 "written")
                      .arg(failed)
                      .arg(verdicts.size()),
            folder);
    }
}

class RunCommand : public Command {
public:
    QString name() const override { return QStringLiteral("run"); }
    QString summary() const override {
        return QStringLiteral("Simulates every dip and writes the sheets to print.");
    }

    void declare(CommandSyntax& syntax) const override {
        declareProjects(syntax,
                        QStringLiteral("Several projects are processed one after the other."));
        syntax.addOption({outOption,
                          QStringLiteral("The folder for the results. Several projects get one "
                                         "subfolder each. Earlier results are replaced."),
                          QStringLiteral("DIR")});
        syntax.addOption({solverOption,
                          QStringLiteral("The solver plugin, instead of the project's choice."),
                          QStringLiteral("ID")});
        syntax.addOption(
            {dpiOption, QStringLiteral("The sheet's resolution."), QStringLiteral("N")});
        declareFilmImage(syntax);
        syntax.addOption(
            {numericalErrorOption,
             QStringLiteral("Skips the dips of coarser films that estimate the "
                            "numerical error of the sheets. Films are then not refined.")});
        syntax.addOption(
            {lawsOption, QStringLiteral("Simulates eight more dips per sheet, to show how much the "
                                        "sheet depends on film laws that are not measured.")});
        syntax.addOption(
            {tolerancesOption,
             QStringLiteral("Simulates dozens of dips per sheet, to show how far the tolerances "
                            "may move the colours, and which zones stay within their limits.")});
        syntax.addOption(
            {cradleOption,
             QStringLiteral(
                 "Also makes a cradle for each dip, to print in plastic: STL and 3MF.")});
        declareRequired(syntax,
                        QStringLiteral("Fails with exit code 3, after all results are written, if "
                                       "the verdict is worse than this: print, check (check "
                                       "first) or any (the default)."),
                        QStringLiteral("any"));
        syntax.addOption(
            {untilOption,
             QStringLiteral("Repeats the dips with smaller film cells only until the numerical "
                            "error is small enough to print the sheets. Without the option, films "
                            "with automatic cells are repeated until they reach the project's "
                            "wanted error (film.wanted_error_mm), too. With the option, other "
                            "films are refused."),
             QStringLiteral("print")});
        syntax.addOption({workOption,
                          QStringLiteral("The limit for smaller cells: film points times steps of "
                                         "one dip, in millions (film.work_million). %1 takes about "
                                         "20 s on two cores, and longer where film folds. 0: the "
                                         "cells stay as they are.")
                              .arg(int(newProjectFilmWork)),
                          QStringLiteral("N")});
        syntax.addOption(
            {motionOption,
             QStringLiteral(
                 "A text template whose {names} are filled in for motion-N.gcode; or "
                 "linuxcnc, grbl or marlin: the program's own template for dips on a path."),
             QStringLiteral("FILE")});
        syntax.addOption(
            {outputsOption,
             QStringLiteral("Writes only these outputs: the name of an output set of the project, "
                            "such as Everything or “Print shop”, or a list such as "
                            "sheet_pdf,traveller."),
             QStringLiteral("NAME")});
        syntax.addOption(
            {overwriteOption,
             QStringLiteral("With --outputs: also replaces files that no output has made.")});
        syntax.addOption(
            {clippingOption, QStringLiteral("With --outputs: accepts that colour outside the "
                                            "printable area is lost in print files.")});
        syntax.addOption(
            {languageOption,
             QStringLiteral(
                 "The language of the traveller, the job line, the notes and the output: en, de "
                 "or pt_BR."),
             QStringLiteral("CODE")});
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const QString folder = parser.value(outOption);
        if (folder.isEmpty()) {
            throw UsageError(QStringLiteral("Name the folder for the results with --out DIR"),
                             QStringLiteral("--out"));
        }
        const QStringList projects = projectPaths(parser);
        if (parser.isSet(outputsOption) && parser.isSet(motionOption)) {
            throw UsageError(
                QStringLiteral("--motion-template cannot be used with --outputs, which "
                               "uses your own motion.gcode or the standard template"),
                QStringLiteral("--motion-template"));
        }
        if (!parser.isSet(outputsOption)) {
            refuseOptions(parser, {overwriteOption, clippingOption},
                          QStringLiteral("without --outputs"));
        }
        const ThreadLimit threads = threadLimit(parser);
        const SolverRegistry registry;
        solverNamed(parser, registry); // fails now instead of after reading the project
        Tasks waking; // wakes the GPU meanwhile, because this takes longer than reading a project
        waking.run([&, cancelToken = console.progress().cancelToken] {
            registry.module(solverToWake(parser, projects.front()), cancelToken);
        });
        const JobOptions options = jobOptions(parser);
        const std::optional<Advice> required = requiredAdvice(parser);
        if (projects.size() == 1) {
            require(required,
                    {runOne(projects.front(), folder, registry, options, parser, console.progress(),
                            console)},
                    folder);
        } else {
            require(required, runAll(projects, folder, registry, options, parser, console), folder);
        }
    }

private:
    // Returns the first project's solver, if it is known before the project is read.
    static QString solverToWake(const QCommandLineParser& parser, const QString& project) {
        if (parser.isSet(solverOption)) {
            return parser.value(solverOption);
        }
        const QString setting = QStringLiteral("process.solver=");
        QString id = solverOfProject(project);
        for (const QString& text : parser.values(QStringLiteral("set"))) {
            if (text.startsWith(setting)) {
                id = text.mid(setting.size());
            }
        }
        return id;
    }

    static JobOptions jobOptions(const QCommandLineParser& parser) {
        JobOptions options;
        options.solver = parser.value(solverOption);
        options.estimatesNumericalError = !parser.isSet(numericalErrorOption);
        options.refines = options.estimatesNumericalError;
        options.variesLaws = parser.isSet(lawsOption);
        options.computesTolerances = parser.isSet(tolerancesOption);
        if (parser.isSet(languageOption)) {
            setLanguage(parser.value(languageOption));
        }
        if (parser.isSet(motionOption)) {
            options.motion = motionTemplate(parser.value(motionOption));
        }
        options.makesCradles = parser.isSet(cradleOption);
        applyFilmImage(options, parser);
        return options;
    }

    // Runs one project and writes its results. Returns the verdict.
    static Advice runOne(const QString& path, const QString& folder, const SolverRegistry& registry,
                         const JobOptions& options, const QCommandLineParser& parser,
                         const Progress& progress, Console& console) {
        Project project = readProject(path, parser);
        if (parser.isSet(dpiOption)) {
            setByOption(project, QStringLiteral("sheet.dpi"), parser.value(dpiOption),
                        QStringLiteral("--dpi"));
        }
        applyRefinement(project, parser);
        if (parser.isSet(outputsOption)) {
            return runForOutputs(project, path, folder, registry, options, parser, progress,
                                 console);
        }
        const JobResult result = runAndWrite(project, registry, options, nullptr, folder, progress);
        printSummary(result, console.out());
        console.out() << Text::tr("Wrote %1").arg(oneLine(folder)) << '\n';
        return verdictToCompare(result);
    }

    // Does the same, but writes only the outputs of --outputs. Uses cached dips, except with
    // --no-certainty.
    static Advice runForOutputs(const Project& project, const QString& path, const QString& folder,
                                const SolverRegistry& registry, const JobOptions& options,
                                const QCommandLineParser& parser, const Progress& progress,
                                Console& console) {
        // throws Error before the job
        checkOutputsFolder(folder, wantedOutputs(project, parser));
        // Cached films may be refined, and are judged.
        const auto cached =
            options.estimatesNumericalError
                ? usableDips(project, registry, path, progress.silent(), console.warnings())
                : nullptr;
        const JobResult result =
            runJob(project, registry, options, cached.get(), progress.part(0, 0.85));
        printSummary(result, console.out());
        writeOutputs(result, folder, path, parser, progress.part(0.85, 1), console.out());
        return verdictToCompare(result);
    }

    // Runs the projects one after the other. If a project fails, reports the error and continues
    // with the next. Returns the verdicts.
    static std::vector<Advice> runAll(const QStringList& projects, const QString& folder,
                                      const SolverRegistry& registry, const JobOptions& options,
                                      const QCommandLineParser& parser, Console& console) {
        const QStringList folders = resultFolders(projects, folder);
        const Progress progress = console.progress();
        std::vector<Advice> verdicts;
        for (qsizetype number = 0; number < projects.size(); ++number) {
            console.out() << Text::tr("Project %1 of %2: %3")
                                 .arg(number + 1)
                                 .arg(projects.size())
                                 .arg(projects[number])
                          << '\n';
            const auto count = double(projects.size());
            try {
                verdicts.push_back(runOne(
                    projects[number], folders[number], registry, options, parser,
                    progress.part(double(number) / count, double(number + 1) / count), console));
            } catch (const UsageError&) {
                throw;
            } catch (const Error& error) {
                console.error(error);
            } catch (const Cancelled&) {
                throw Error(QStringLiteral("Cancelled: %1 of %2 projects are done")
                                .arg(verdicts.size())
                                .arg(projects.size()),
                            projects[number]);
            }
            console.out().flush(); // shows the finished project while the next one runs
        }
        if (verdicts.size() < std::size_t(projects.size())) {
            throw Error(QStringLiteral(
                            "%1 of %2 projects are done; the errors of the others are listed above")
                            .arg(verdicts.size())
                            .arg(projects.size()),
                        folder);
        }
        return verdicts;
    }
};

} // namespace

std::unique_ptr<Command> runCommand() {
    return std::make_unique<RunCommand>();
}

} // namespace dipwright::cli
