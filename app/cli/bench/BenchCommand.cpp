#include "cli/Arguments.h"
#include "cli/bench/BenchReport.h"

#include <QJsonDocument>

namespace dipwright::cli {
namespace {

const QString jsonOption = QStringLiteral("json");
const QString solverOption = QStringLiteral("solver");
const QString rowsOption = QStringLiteral("rows");
const QString runsOption = QStringLiteral("runs");
const QString partsOption = QStringLiteral("parts");
const QString quickOption = QStringLiteral("quick");
const QString plotOption = QStringLiteral("plot");

const QStringList allParts{
    QStringLiteral("steps"), QStringLiteral("dips"),  QStringLiteral("large-dips"),
    QStringLiteral("sweep"), QStringLiteral("field"), QStringLiteral("texture"),
    QStringLiteral("parts"), QStringLiteral("run"),   QStringLiteral("live")};
const QStringList usualParts{QStringLiteral("steps"), QStringLiteral("dips")};

constexpr int tableOneRows = 8;

// Returns the parts that --parts names. Throws UsageError for an unknown part, or if a plot is
// requested without a part that it shows.
QStringList chosenParts(const QCommandLineParser& parser) {
    QStringList parts = usualParts;
    if (parser.isSet(partsOption)) {
        parts = parser.value(partsOption).split(QLatin1Char(','), Qt::SkipEmptyParts);
    } else if (parser.isSet(plotOption)) {
        parts += QStringLiteral("sweep");
    }
    if (parts == QStringList(QStringLiteral("all"))) {
        parts = allParts;
    }
    for (const QString& part : parts) {
        if (!allParts.contains(part)) {
            throw UsageError(QStringLiteral("There is no part %1; choose from %2, all")
                                 .arg(part, allParts.join(QStringLiteral(", "))),
                             QStringLiteral("--parts"));
        }
    }
    const bool isPlotted =
        parts.contains(QLatin1String("steps")) || parts.contains(QLatin1String("sweep"));
    if (parts.isEmpty() || (parser.isSet(plotOption) && !isPlotted)) {
        throw UsageError(
            QStringLiteral("A plot shows the parts steps and sweep; choose at least one of them"),
            QStringLiteral("--parts"));
    }
    return parts;
}

// Splits the progress evenly between the parts.
class PartProgress {
public:
    PartProgress(const Progress& whole, const QStringList& parts) : whole_(whole), parts_(parts) {}
    Progress next() {
        const double share = 1.0 / double(parts_.size());
        ++begun_;
        return whole_.part((begun_ - 1) * share, begun_ * share);
    }

private:
    const Progress& whole_;
    const QStringList& parts_;
    int begun_ = 0;
};

void append(std::vector<TimedRow>& rows, std::vector<TimedRow> more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

BenchReport measured(const BenchSolver& solver, const QStringList& parts, int rows, bool isQuick,
                     const QStringList& projects, const Progress& progress) {
    BenchReport report;
    BenchBodies bodies;
    PartProgress each(progress, parts);
    report.runs = solver.runs;
    for (const QString& part : parts) {
        const Progress partProgress = each.next();
        if (part == QLatin1String("steps")) {
            report.tableOne = measureTableOne(solver, bodies, rows, partProgress);
        } else if (part == QLatin1String("dips")) {
            append(report.dips, measureDips(solver, bodies, 120, 170, partProgress));
        } else if (part == QLatin1String("large-dips")) {
            append(report.dips, measureDips(solver, bodies, 280, 396, partProgress));
        } else if (part == QLatin1String("sweep")) {
            report.fieldSweep = measureFieldSweep(solver, bodies, isQuick ? 64 : 512, partProgress);
        } else if (part == QLatin1String("field")) {
            report.fields = measureFields(solver.runs, isQuick ? 64 : 512, partProgress);
        } else if (part == QLatin1String("texture")) {
            const std::vector<int> resolutions =
                isQuick ? std::vector<int>{100} : std::vector<int>{300, 600};
            report.sheets = measureSheets(solver, resolutions, partProgress);
        } else if (part == QLatin1String("parts")) {
            report.runParts = measureParts(solver, partProgress);
        } else if (part == QLatin1String("live")) {
            report.live = measureLive(solver, projects, partProgress);
        } else {
            report.wholeRuns = measureRun(solver, partProgress);
        }
    }
    return report;
}

std::optional<solver::Ceiling> ceilingOf(const solver::SolverModule& module, const QString& id) {
    try {
        return module.measuredCeiling();
    } catch (const Cancelled&) {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error(QStringLiteral("The solver failed: %1").arg(QString::fromUtf8(failure.what())),
                    id);
    }
}

class BenchCommand : public Command {
public:
    QString name() const override { return QStringLiteral("bench"); }
    QString summary() const override {
        return QStringLiteral("Measures the solver on the paper's Table I and on whole dips; "
                              "optionally also all other parts of a job.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addOption({jsonOption, QStringLiteral("Prints JSON.")});
        syntax.addOption({solverOption, QStringLiteral("The solver plugin."), QStringLiteral("ID"),
                          QStringLiteral("auto")});
        syntax.addOption({rowsOption,
                          QStringLiteral("Measures only the first N rows of Table I, 1 to 8."),
                          QStringLiteral("N"), QString::number(tableOneRows)});
        syntax.addOption({runsOption,
                          QStringLiteral("The number of runs for each row; the median counts."),
                          QStringLiteral("N"), QStringLiteral("3")});
        syntax.addOption(
            {partsOption,
             QStringLiteral(
                 "The parts to measure, joined by commas: steps (Table I), dips (20,400 points), "
                 "large-dips (110,880 points), sweep (Figure 7), field (building the distance "
                 "field), texture (with the sheet), parts (the steps of a job other than the dip), "
                 "run (the whole job), live (how soon results follow a turn of the part), or all. "
                 "Without it: steps,dips."),
             QStringLiteral("LIST")});
        syntax.addOption(
            {quickOption, QStringLiteral("Measures only the coarsest fields and sheets.")});
        syntax.addOption(
            {plotOption,
             QStringLiteral(
                 "Draws the paper's Figures 6 and 7 with the measured rates of steps and sweep."),
             QStringLiteral("FILE.png|FILE.svg")});
        syntax.addPositionalArgument(
            QStringLiteral("[JOB.dipw …]"),
            QStringLiteral("The projects to measure for live. Without one: the samples."));
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const ThreadLimit threads = threadLimit(parser);
        const int rows = wholeNumberOption(parser, rowsOption, 1, tableOneRows);
        const int runs = wholeNumberOption(parser, runsOption, 1, 1000);
        const QStringList parts = chosenParts(parser);
        const QStringList projects = parser.positionalArguments();
        if (!projects.isEmpty() && !parts.contains(QLatin1String("live"))) {
            throw UsageError(QStringLiteral("Only the part live measures projects"), projects[0]);
        }
        const QString plot = pictureOption(parser, plotOption, {".png", ".svg"});
        const SolverRegistry registry;
        const Progress progress = console.progress();
        const QString id = registry.info(solverNamed(parser, registry), progress.cancelToken).id;
        // Measured first, because this also wakes the device.
        const std::optional<solver::Ceiling> ceiling = ceilingOf(registry.module(id), id);
        BenchReport report = measured({registry, id, runs}, parts, rows, parser.isSet(quickOption),
                                      projects, progress);
        report.device = QString::fromUtf8(registry.module(id).device());
        report.solver = registry.info(id);
        report.ceiling = ceiling;
        if (!plot.isEmpty()) {
            drawPlot(report, plot);
        }
        if (parser.isSet(jsonOption)) {
            console.out() << QJsonDocument(toJson(report)).toJson();
        } else {
            print(report, console.out());
        }
    }
};

} // namespace

std::unique_ptr<Command> benchCommand() {
    return std::make_unique<BenchCommand>();
}

} // namespace dipwright::cli
